// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/voronoi.hpp"

#include "repose/core/errors.hpp"
#include "repose/neighbours/cell_grid.hpp"

#include <voro++/cell.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace repose {

namespace {

constexpr int cut_off_sides = 32;

// The origin of a face of a cell. A cell starts as a prism, whose faces voro++ numbers from -1 to -6: left, right,
// lower and upper side, and the two ends.
constexpr int last_starting_side = -4;
constexpr int end_of_prism = -6;
constexpr int cut_off_side = -7;
constexpr int wall_side = -8;
constexpr int neighbour_side = 1;

bool at_cut_off(int face) { return (face < 0 && face >= last_starting_side) || face == cut_off_side; }

/// The grains that have or bound cells, in their order.
struct Sites {
  std::vector<std::size_t> grain;  // index in memory
  std::vector<Vec<2>> position;    // [L]
  double largest = 0.0;            // [L] largest radius
  double largest_with_cell = 0.0;  // [L] largest radius of a grain with a cell
};

Sites find_sites(const Grains<2>& grains, const std::vector<bool>& in_heap) {
  Sites sites;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (!in_heap[k] && !grain.fixed()) continue;
    sites.grain.push_back(k);
    sites.position.push_back(grain.position);
    sites.largest = std::max(sites.largest, grain.radius);
    if (in_heap[k]) sites.largest_with_cell = std::max(sites.largest_with_cell, grain.radius);
  }
  return sites;
}

/// A neighbour relative to the centre of a cell. Lengths are in units of the largest diameter.
struct Neighbour {
  Vec<2> offset{};
  double distance_squared = 0.0;
  double plane = 0.0;  // twice the distance of the radical line, times the distance of the neighbour
};

/// Finds the neighbours of a site that can cut its cell, nearest first.
class Surroundings {
 public:
  Surroundings(const Grains<2>& grains, const Sites& sites, const Box<2>& box, double unit, double cut_off)
      : grains_(grains),
        sites_(sites),
        box_(box),
        unit_(unit),
        cut_off_(cut_off),
        grid_(sites.position, box, 2.0 * unit) {}

  const std::vector<Neighbour>& of(std::size_t site) {
    near_.clear();
    // The radical line of a neighbour at distance d lies (d^2 + r_i^2 - r_j^2) / (2 d) away. If d exceeds this reach,
    // it lies beyond the corners of the cut-off.
    const double corner = cut_off_ * unit_ / std::cos(std::numbers::pi / cut_off_sides);
    const double radius = grains_.line[sites_.grain[site]].radius;
    const double reach = corner + std::sqrt(squared(corner) + squared(sites_.largest) - squared(radius));
    const auto cell = grid_.cell_of(sites_.position[site]);
    const int high = static_cast<int>(std::ceil(reach / grid_.size(1)));
    const int wide = static_cast<int>(std::ceil(reach / grid_.size(0)));
    const int lines = grid_.count(0);
    if (2 * wide + 1 >= lines) {
      for (int line = 0; line < lines; ++line) add(site, grid_.places(line, cell[1] - high, cell[1] + high), reach);
    } else {
      for (int line = cell[0] - wide; line <= cell[0] + wide; ++line) {
        if (!box_.periodic && (line < 0 || line >= lines)) continue;
        add(site, grid_.places((line + lines) % lines, cell[1] - high, cell[1] + high), reach);
      }
    }
    std::sort(near_.begin(), near_.end(),
              [](const auto& a, const auto& b) { return a.distance_squared < b.distance_squared; });
    return near_;
  }

 private:
  void add(std::size_t site, CellGrid<2>::Places places, double reach) {
    const int images = box_.periodic ? static_cast<int>(reach / box_.width() + 0.5) : 0;
    const double radius = grains_.line[sites_.grain[site]].radius;
    for (auto place = places.begin; place < places.end; ++place) {
      const auto other = grid_.order()[place];
      const Vec<2> nearest = separation(sites_.position[other], sites_.position[site], box_);
      const double other_radius = grains_.line[sites_.grain[other]].radius;
      for (int image = -images; image <= images; ++image) {
        if (other == site && image == 0) continue;
        Vec<2> offset = nearest;
        if (image != 0) offset[0] += image * box_.width();
        const double distance_squared = squared(offset);
        if (distance_squared > squared(reach)) continue;
        const double scale = 1.0 / squared(unit_);
        near_.push_back({offset * (1.0 / unit_), distance_squared * scale,
                         (distance_squared + squared(radius) - squared(other_radius)) * scale});
      }
    }
  }

  const Grains<2>& grains_;
  const Sites& sites_;
  const Box<2>& box_;
  double unit_;
  double cut_off_;
  CellGrid<2> grid_;
  std::vector<Neighbour> near_;
};

/// The polygon of one cell, about the origin and in units of the largest diameter: the end of a prism that voro++ cuts.
class Polygon {
 public:
  explicit Polygon(double cut_off) : cut_off_(cut_off) {
    for (int side = 0; side < cut_off_sides; ++side) {
      const double angle = 2.0 * std::numbers::pi * side / cut_off_sides;
      normals_[static_cast<std::size_t>(side)] = {{std::cos(angle), std::sin(angle)}};
    }
  }

  void start() {
    prism_.init(-cut_off_, cut_off_, -cut_off_, cut_off_, -0.5, 0.5);
    empty_ = false;
  }
  /// Keeps the points x with 2 x . towards < limit.
  void keep_below(const Vec<2>& towards, double limit, int face) {
    if (!empty_) empty_ = !prism_.nplane(towards[0], towards[1], 0.0, limit, face);
  }
  /// Cuts the cell off at the cut-off polygon. Call this last: few cells reach so far.
  void cut_off_corners() {
    if (empty_) return;
    prism_.vertices(places_);
    double farthest = 0.0;
    for (std::size_t k = 0; k < places_.size(); k += 3)
      farthest = std::max(farthest, squared(Vec<2>{{places_[k], places_[k + 1]}}));
    if (farthest <= squared(cut_off_)) return;
    for (int side = 0; side < cut_off_sides; ++side) {
      if (side % (cut_off_sides / 4) == 0) continue;  // the prism started with these four
      keep_below(normals_[static_cast<std::size_t>(side)], 2.0 * cut_off_, cut_off_side);
    }
  }

  /// Sets the vertices, the area and `closed` of the cell of a grain at `centre`.
  void store(VoronoiCell& cell, const Vec<2>& centre, double unit) {
    cell.closed = true;
    if (empty_) return;
    prism_.vertices(places_);
    prism_.neighbors(faces_);
    prism_.face_vertices(corners_);  // for each face, the number of its vertices, then the vertices in order
    std::size_t at = 0;
    for (const int face : faces_) {
      const auto count = static_cast<std::size_t>(corners_[at]);
      if (at_cut_off(face)) cell.closed = false;
      if (face == end_of_prism) store_outline(cell, at + 1, count);
      at += count + 1;
    }
    cell.area *= squared(unit);
    for (auto& vertex : cell.vertices) vertex = centre + vertex * unit;
  }

 private:
  void store_outline(VoronoiCell& cell, std::size_t first, std::size_t count) {
    for (std::size_t k = first; k < first + count; ++k) {
      const auto place = 3 * static_cast<std::size_t>(corners_[k]);
      cell.vertices.push_back({{places_[place], places_[place + 1]}});
    }
    double doubled = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto& a = cell.vertices[k];
      const auto& b = cell.vertices[(k + 1) % count];
      doubled += a[0] * b[1] - a[1] * b[0];
    }
    if (doubled < 0.0) std::reverse(cell.vertices.begin(), cell.vertices.end());
    cell.area = 0.5 * std::fabs(doubled);
  }

  double cut_off_;  // inscribed radius
  std::array<Vec<2>, cut_off_sides> normals_{};
  voro::voronoicell_neighbor prism_;
  bool empty_ = false;
  std::vector<double> places_;
  std::vector<int> faces_;
  std::vector<int> corners_;
};

}  // namespace

std::vector<VoronoiCell> voronoi(const OrderedGrains<2>& ordered, const std::vector<bool>& in_heap,
                                 const std::vector<FlatWall>& walls, const Box<2>& box, double cut_off) {
  const auto& grains = *ordered;
  REPOSE_ASSERT(in_heap.size() == grains.size());
  std::vector<VoronoiCell> cells;
  const Sites sites = find_sites(grains, in_heap);
  if (!(sites.largest_with_cell > 0.0)) return cells;
  const double unit = 2.0 * sites.largest_with_cell;  // keeps the absolute tolerance of voro++ small
  Surroundings surroundings(grains, sites, box, unit, cut_off);
  Polygon polygon(cut_off);
  for (std::size_t site = 0; site < sites.grain.size(); ++site) {
    const auto k = sites.grain[site];
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    polygon.start();
    for (const auto& neighbour : surroundings.of(site))
      polygon.keep_below(neighbour.offset, neighbour.plane, neighbour_side);
    for (const auto& wall : walls) {
      const double height = dot(grain.position - wall.point, wall.normal) / unit;
      polygon.keep_below(-wall.normal, 2.0 * height, wall_side);
    }
    polygon.cut_off_corners();
    VoronoiCell& cell = cells.emplace_back();
    cell.id = grains.id[k];
    polygon.store(cell, grain.position, unit);
    cell.solid_fraction = cell.area > 0.0 ? std::numbers::pi * squared(grain.radius) / cell.area
                                          : std::numeric_limits<double>::quiet_NaN();
  }
  return cells;
}

}  // namespace repose
