// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_cells.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/numbers.hpp"

#include <voro++/c_loops.hh>
#include <voro++/container.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace repose {

namespace {

// voro++ numbers the sides of a box from -1 to -6; grains have numbers from 0.
constexpr int last_side_of_box = -6;
constexpr int cut_off_face = -7;
constexpr int wall_face = -8;
constexpr double tangents_apart = 0.25;  // [largest diameters] along a cylinder
constexpr double grains_per_block = 5.0;

/// The grains that have or bound cells, in their order. Lengths are in units of the largest diameter.
struct Sites {
  std::vector<std::size_t> grain;  // place in memory
  double unit = 0.0;               // [L] largest diameter of a grain with a cell
  Vec<3> low{};                    // corners of the box around all cells
  Vec<3> high{};
};

Sites find_sites(const Grains<3>& grains, const std::vector<bool>& in_heap, const Box<3>& box, double cut_off) {
  Sites sites;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) sites.unit = std::max(sites.unit, 2.0 * grains.line[k].radius);
  }
  if (!(sites.unit > 0.0)) return sites;
  bool is_first = true;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if ((!in_heap[k] && !grain.fixed()) || !std::isfinite(magnitude(grain.position))) continue;
    sites.grain.push_back(k);
    const Vec<3> at = grain.position * (1.0 / sites.unit);
    for (int axis = 0; axis < 3; ++axis) {
      sites.low[axis] = is_first ? at[axis] : std::min(sites.low[axis], at[axis]);
      sites.high[axis] = is_first ? at[axis] : std::max(sites.high[axis], at[axis]);
    }
    is_first = false;
  }
  const double margin = 2.0 * cut_off;  // beyond the corners of the cut-off
  for (int axis = 0; axis < 3; ++axis) {
    sites.low[axis] -= margin;
    sites.high[axis] += margin;
  }
  if (box.periodic) {
    sites.low[0] = box.x_min / sites.unit;
    sites.high[0] = box.x_max / sites.unit;
  }
  if (box.periodic_y) {
    sites.low[1] = box.y_min / sites.unit;
    sites.high[1] = box.y_max / sites.unit;
  }
  return sites;
}

/// Blocks along each axis such that they hold a few grains each, as voro++ advises.
std::array<int, 3> blocks_of(const Sites& sites) {
  const Vec<3> size = sites.high - sites.low;
  const double count = static_cast<double>(sites.grain.size()) / grains_per_block;
  const double side = std::cbrt(size[0] * size[1] * size[2] / std::max(1.0, count));
  std::array<int, 3> blocks{};
  for (int axis = 0; axis < 3; ++axis) {
    blocks[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp(std::ceil(size[axis] / side), 1.0, 200.0));
  }
  return blocks;
}

/// Outward normals of the cut-off: the directions from the middle of a cube to its faces, edges and corners.
std::vector<Vec<3>> cut_off_normals() {
  std::vector<Vec<3>> normals;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Vec<3> towards{{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}};
        if (squared(towards) > 0.0) normals.push_back(towards * (1.0 / magnitude(towards)));
      }
    }
  }
  return normals;
}

/// A cell about the centre of its grain, as voro++ has cut it by the neighbours.
class CellCutter {
 public:
  CellCutter(const CellWalls& walls, double unit, double cut_off)
      : walls_(walls), unit_(unit), cut_off_(cut_off), cut_off_normals_(cut_off_normals()) {}

  /// Cuts the cell off at walls and at the cut-off. `centre` [L] is that of the grain. Whether anything is left.
  bool cut(voro::voronoicell_neighbor& cell, const Vec<3>& centre) {
    for (const auto& plane : walls_.planes) {
      const double height = dot(centre - plane.point, plane.normal) / unit_;
      if (!keep_below(cell, -plane.normal, height, wall_face)) return false;
    }
    for (const auto& cylinder : walls_.cylinders) {
      if (!cut_by(cell, cylinder, centre)) return false;
    }
    if (farthest(cell) <= cut_off_) return true;
    for (const auto& normal : cut_off_normals_) {
      if (!keep_below(cell, normal, cut_off_, cut_off_face)) return false;
    }
    return true;
  }

 private:
  /// Keeps the points x with x . normal < distance.
  static bool keep_below(voro::voronoicell_neighbor& cell, const Vec<3>& normal, double distance, int face) {
    return cell.nplane(normal[0], normal[1], normal[2], 2.0 * distance, face);
  }

  double farthest(voro::voronoicell_neighbor& cell) {
    cell.vertices(places_);
    double most = 0.0;
    for (std::size_t k = 0; k < places_.size(); k += 3) {
      most = std::max(most, squared(Vec<3>{{places_[k], places_[k + 1], places_[k + 2]}}));
    }
    return std::sqrt(most);
  }

  /// Cuts by planes that touch the cylinder around the grain, so far along it as the cut-off reaches.
  bool cut_by(voro::voronoicell_neighbor& cell, const CellWalls::Cylinder& cylinder, const Vec<3>& centre) const {
    const Vec<3> from_axis = tangential(centre - cylinder.point, cylinder.axis) * (1.0 / unit_);
    const double distance = magnitude(from_axis);
    const double radius = cylinder.radius / unit_;
    if (radius - distance > 2.0 * cut_off_) return true;
    Vec<3> out = from_axis * (1.0 / distance);
    if (!(distance > 0.0)) {
      const Vec<3> any = std::fabs(cylinder.axis[0]) < 0.5 ? Vec<3>{{1.0, 0.0, 0.0}} : Vec<3>{{0.0, 1.0, 0.0}};
      out = tangential(any, cylinder.axis);
      out *= 1.0 / magnitude(out);
    }
    const Vec<3> along = cross(cylinder.axis, out);
    const double turn = std::min(2.0 * std::numbers::pi, 4.0 * cut_off_ / radius);
    const int steps = std::max(2, static_cast<int>(std::ceil(0.5 * turn * radius / tangents_apart)));
    for (int k = -steps; k <= steps; ++k) {
      const double angle = 0.5 * turn * k / steps;
      const Vec<3> normal = out * std::cos(angle) + along * std::sin(angle);
      if (!keep_below(cell, normal, radius - distance * std::cos(angle), wall_face)) return false;
    }
    return true;
  }

  const CellWalls& walls_;
  double unit_;
  double cut_off_;
  std::vector<Vec<3>> cut_off_normals_;
  std::vector<double> places_;
};

}  // namespace

std::vector<SphereCell> sphere_cells(const OrderedGrains<3>& ordered, const std::vector<bool>& in_heap,
                                     const CellWalls& walls, const Box<3>& box, double cut_off) {
  const auto& grains = *ordered;
  REPOSE_ASSERT(in_heap.size() == grains.size());
  std::vector<SphereCell> cells;
  const Sites sites = find_sites(grains, in_heap, box, cut_off);
  if (!(sites.unit > 0.0)) return cells;
  const auto blocks = blocks_of(sites);
  constexpr int memory = 8;  // grains per block at first
  voro::container_poly container(sites.low[0], sites.high[0], sites.low[1], sites.high[1], sites.low[2], sites.high[2],
                                 blocks[0], blocks[1], blocks[2], box.periodic, box.periodic_y, false, memory);
  voro::particle_order order;
  for (std::size_t site = 0; site < sites.grain.size(); ++site) {
    const auto& grain = grains.line[sites.grain[site]];
    const Vec<3> at = grain.position * (1.0 / sites.unit);
    container.put(order, static_cast<int>(site), at[0], at[1], at[2], grain.radius / sites.unit);
  }
  CellCutter cutter(walls, sites.unit, cut_off);
  voro::voronoicell_neighbor found;
  std::vector<int> faces;
  voro::c_loop_order place(container, order);
  if (!place.start()) return cells;
  do {
    const auto k = sites.grain[static_cast<std::size_t>(place.pid())];
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    SphereCell cell{.id = grains.id[k], .place = k, .solid_fraction = no_number};
    if (container.compute_cell(found, place) && cutter.cut(found, grain.position)) {
      found.neighbors(faces);
      const bool open = std::any_of(faces.begin(), faces.end(), [](int face) {
        return face == cut_off_face || (face < 0 && face >= last_side_of_box);
      });
      cell.closed = !open;
      cell.volume = found.volume() * sites.unit * sites.unit * sites.unit;
      const double radius = grain.radius;
      cell.solid_fraction = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius / cell.volume;
    }
    cells.push_back(cell);
  } while (place.inc());
  return cells;
}

}  // namespace repose
