// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/voronoi.hpp"

#include "repose/neighbours/cell_grid.hpp"

#include <voro++/voro++.hh>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace repose {

namespace {

constexpr double cut_off = 1.5;  // largest diameters
constexpr int sides = 32;        // of the polygon that cells are cut off by
constexpr double reach =
    3.2;  // largest diameters: no radical plane of a farther neighbour comes nearer than the cut-off
constexpr int id_of_polygon = -100;
constexpr int id_of_neighbour = 1;

/// A neighbour as seen from the centre of a cell, in units of the largest diameter.
struct Neighbour {
  Vec<2> away{};
  double twice_plane = 0.0;  // d^2 + r_i^2 - r_j^2: the radical plane is half of it along `away`
};

/// Cells of one packing, worked out one by one in units of its largest diameter.
class Tessellation {
 public:
  Tessellation(const Grains<2>& grains, std::vector<std::uint32_t> members, const std::vector<Edge>& edges,
               const Box<2>& box)
      : grains_(grains),
        edges_(edges),
        box_(box),
        members_(std::move(members)),
        unit_(largest_diameter()),
        grid_(positions(), box, reach * unit_) {}

  VoronoiCell cell(std::uint32_t grain) const;

 private:
  double largest_diameter() const {
    double largest = 0.0;
    for (const auto k : members_) largest = std::max(largest, 2.0 * grains_.line[k].radius);
    return largest;
  }
  std::vector<Vec<2>> positions() const {
    std::vector<Vec<2>> all;
    for (const auto k : members_) all.push_back(grains_.line[k].position);
    return all;
  }
  std::vector<Neighbour> neighbours(std::uint32_t grain) const;

  const Grains<2>& grains_;
  const std::vector<Edge>& edges_;
  const Box<2>& box_;
  std::vector<std::uint32_t> members_;
  double unit_;
  CellGrid<2> grid_;
};

std::vector<Neighbour> Tessellation::neighbours(std::uint32_t grain) const {
  const auto& self = grains_.line[grain];
  const auto at = grid_.cell_of(self.position);
  std::set<int> lines;
  for (int line = at[0] - 1; line <= at[0] + 1; ++line) {
    if (box_.periodic) {
      lines.insert((line + grid_.count(0)) % grid_.count(0));
    } else if (line >= 0 && line < grid_.count(0)) {
      lines.insert(line);
    }
  }
  std::vector<Neighbour> found;
  for (const int line : lines) {
    const auto places = grid_.places(line, at[1] - 1, at[1] + 1);
    for (auto place = places.begin; place < places.end; ++place) {
      const auto other = members_[grid_.order()[place]];
      if (other == grain) continue;
      const Vec<2> away = separation(grains_.line[other].position, self.position, box_) * (1.0 / unit_);
      const double radius = self.radius / unit_;
      const double other_radius = grains_.line[other].radius / unit_;
      if (dot(away, away) > reach * reach) continue;
      found.push_back({away, dot(away, away) + radius * radius - other_radius * other_radius});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return dot(a.away, a.away) < dot(b.away, b.away); });
  return found;
}

VoronoiCell Tessellation::cell(std::uint32_t grain) const {
  const auto& self = grains_.line[grain];
  voro::voronoicell_neighbor prism;  // of unit height, so that its volume is the area of the cell
  constexpr double far = 2.0 * cut_off;
  prism.init(-far, far, -far, far, -0.5, 0.5);
  for (int side = 0; side < sides; ++side) {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    prism.nplane(std::cos(angle), std::sin(angle), 0.0, 2.0 * cut_off, id_of_polygon);
  }
  bool left = true;  // something is left of the cell: two grains at the same place share none
  for (const auto& neighbour : neighbours(grain)) {
    left = left && prism.nplane(neighbour.away[0], neighbour.away[1], 0.0, neighbour.twice_plane, id_of_neighbour);
  }
  for (const auto& edge : edges_) {
    const double height = dot(self.position - edge.point, edge.normal) / unit_;
    left = left && prism.nplane(-edge.normal[0], -edge.normal[1], 0.0, 2.0 * height, id_of_neighbour);
  }
  VoronoiCell cell;
  cell.id = grains_.id[grain];
  if (!left) return cell;
  cell.area = prism.volume() * unit_ * unit_;
  cell.solid_fraction = std::numbers::pi * self.radius * self.radius / cell.area;
  std::vector<int> faces;
  prism.neighbors(faces);
  cell.closed = std::find(faces.begin(), faces.end(), id_of_polygon) == faces.end();
  std::vector<double> corners;
  prism.vertices(0.0, 0.0, 0.0, corners);
  std::vector<std::pair<double, Vec<2>>> by_angle;
  Vec<2> middle{};
  double count = 0.0;
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    if (corners[k + 2] < 0.0) continue;
    middle += Vec<2>{{corners[k], corners[k + 1]}};
    count += 1.0;
  }
  middle = middle * (1.0 / count);
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    if (corners[k + 2] < 0.0) continue;
    const Vec<2> corner{{corners[k], corners[k + 1]}};
    by_angle.emplace_back(std::atan2(corner[1] - middle[1], corner[0] - middle[0]), corner);
  }
  std::sort(by_angle.begin(), by_angle.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [angle, corner] : by_angle) cell.vertices.push_back(self.position + corner * unit_);
  return cell;
}

}  // namespace

std::vector<VoronoiCell> voronoi(const Grains<2>& grains, const std::vector<bool>& in_heap,
                                 const std::vector<Edge>& edges, const Box<2>& box) {
  std::vector<VoronoiCell> cells;
  std::vector<std::uint32_t> members;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k] || grains.line[k].fixed()) members.push_back(k);
  }
  if (members.empty()) return cells;
  const Tessellation tessellation(grains, members, edges, box);
  for (const auto k : by_id(grains)) {
    if (in_heap[k]) cells.push_back(tessellation.cell(k));
  }
  return cells;
}

}  // namespace repose
