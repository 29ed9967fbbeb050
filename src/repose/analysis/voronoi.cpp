// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/voronoi.hpp"

#include "repose/analysis/visible_part.hpp"
#include "repose/core/errors.hpp"
#include "repose/neighbours/cell_grid.hpp"

#include <voro++/cell.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

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

double doubled_area(const std::vector<Vec<2>>& vertices) {
  double doubled = 0.0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto& a = vertices[k];
    const auto& b = vertices[(k + 1) % vertices.size()];
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  return doubled;
}

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

  /// The outline of the cell; without vertices if nothing is left.
  Outline outline() {
    if (empty_) return {};
    return find_outline();
  }

 private:
  Outline find_outline() {
    prism_.vertices(places_);
    prism_.neighbors(faces_);
    prism_.face_vertices(corners_);  // for each face, the number of its vertices, then the vertices in order
    Outline outline;
    std::vector<int> ends;                 // numbers of the vertices of the outline
    std::vector<std::array<int, 2>> open;  // sides at the cut-off
    std::size_t at = 0;
    for (const int face : faces_) {
      const auto count = static_cast<std::size_t>(corners_[at]);
      const auto corner = [&](std::size_t k) { return corners_[at + 1 + k % count]; };
      for (std::size_t k = 0; k < count; ++k) {
        if (at_cut_off(face)) open.push_back({corner(k), corner(k + 1)});
        if (face == end_of_prism) ends.push_back(corner(k));
      }
      at += count + 1;
    }
    const auto place_of = [&](int number) {
      const auto place = 3 * static_cast<std::size_t>(number);
      return Vec<2>{{places_[place], places_[place + 1]}};
    };
    for (const int number : ends) outline.vertices.push_back(place_of(number));
    if (doubled_area(outline.vertices) < 0.0) {
      std::reverse(outline.vertices.begin(), outline.vertices.end());
      std::reverse(ends.begin(), ends.end());
    }
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const int a = ends[k];
      const int b = ends[(k + 1) % ends.size()];
      const bool cut_off = std::any_of(open.begin(), open.end(), [&](const auto& side) {
        return side == std::array{a, b} || side == std::array{b, a};
      });
      outline.bounded.push_back(cut_off ? 0 : 1);
    }
    return outline;
  }

  double cut_off_;  // inscribed radius
  std::array<Vec<2>, cut_off_sides> normals_{};
  voro::voronoicell_neighbor prism_;
  bool empty_ = false;
  std::vector<double> places_;
  std::vector<int> faces_;
  std::vector<int> corners_;
};

/// The cell of a site, about its centre and in units of the largest diameter.
class CellFinder {
 public:
  CellFinder(const Grains<2>& grains, const Sites& sites, const std::vector<FlatWall>& walls, const Box<2>& box,
             double cut_off)
      : grains_(grains),
        sites_(sites),
        walls_(walls),
        box_(box),
        unit_(2.0 * sites.largest_with_cell),  // keeps the absolute tolerance of voro++ small
        corner_(cut_off / std::cos(std::numbers::pi / cut_off_sides)),
        surroundings_(grains, sites, box, unit_, cut_off),
        polygon_(cut_off) {}

  VoronoiCell of(std::size_t site) {
    const auto k = sites_.grain[site];
    const auto& grain = grains_.line[k];
    const auto& neighbours = surroundings_.of(site);
    const auto pieces = pieces_near(grain.position, walls_, box_, unit_, corner_);
    std::vector<Neighbour> seen;
    for (const auto& neighbour : neighbours) {
      const bool hidden =
          std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) { return hides(piece, neighbour.offset); });
      if (!hidden) seen.push_back(neighbour);
    }
    VoronoiCell cell;
    cell.id = grains_.id[k];
    const auto all = outline(grain, neighbours);
    if (pieces.empty()) {
      cell.vertices = all.vertices;
      cell.closed = std::find(all.bounded.begin(), all.bounded.end(), 0) == all.bounded.end();
    } else {
      auto part = visible_part(all, seen.size() < neighbours.size() ? outline(grain, seen) : all, pieces);
      cell.vertices = std::move(part.vertices);
      cell.closed = part.closed;
    }
    cell.area = 0.5 * std::fabs(doubled_area(cell.vertices)) * squared(unit_);
    for (auto& vertex : cell.vertices) vertex = grain.position + vertex * unit_;
    cell.solid_fraction = cell.area > 0.0 ? std::numbers::pi * squared(grain.radius) / cell.area
                                          : std::numeric_limits<double>::quiet_NaN();
    return cell;
  }

 private:
  Outline outline(const Grain<2>& grain, const std::vector<Neighbour>& neighbours) {
    polygon_.start();
    for (const auto& neighbour : neighbours) polygon_.keep_below(neighbour.offset, neighbour.plane, neighbour_side);
    for (const auto& wall : walls_) {
      if (std::isfinite(wall.half_length)) continue;
      const double height = dot(grain.position - wall.point, wall.normal) / unit_;
      polygon_.keep_below(-wall.normal, 2.0 * height, wall_side);
    }
    polygon_.cut_off_corners();
    return polygon_.outline();
  }

  const Grains<2>& grains_;
  const Sites& sites_;
  const std::vector<FlatWall>& walls_;
  const Box<2>& box_;
  double unit_;
  double corner_;  // distance of the corners of the cut-off
  Surroundings surroundings_;
  Polygon polygon_;
};

}  // namespace

std::vector<VoronoiCell> voronoi(const OrderedGrains<2>& ordered, const std::vector<bool>& in_heap,
                                 const std::vector<FlatWall>& walls, const Box<2>& box, double cut_off) {
  const auto& grains = *ordered;
  REPOSE_ASSERT(in_heap.size() == grains.size());
  std::vector<VoronoiCell> cells;
  const Sites sites = find_sites(grains, in_heap);
  if (!(sites.largest_with_cell > 0.0)) return cells;
  CellFinder finder(grains, sites, walls, box, cut_off);
  for (std::size_t site = 0; site < sites.grain.size(); ++site) {
    if (in_heap[sites.grain[site]]) cells.push_back(finder.of(site));
  }
  return cells;
}

}  // namespace repose
