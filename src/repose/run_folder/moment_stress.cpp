// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/moment_stress.hpp"

#include "repose/analysis/grain_stress.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/analysis/sphere_cells.hpp"
#include "repose/analysis/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace repose {

namespace {

using Kind = WallShape<3>::Kind;

/// Adds the plane of a flat wall, with its normal to the side on which all the centres lie.
void add_plane(const Wall<3>& wall, const std::vector<Vec<3>>& centres, CellWalls& bounds) {
  const auto above = [&](const Vec<3>& centre) { return dot(Vec<3>(centre - wall.point), wall.normal) > 0.0; };
  const auto count = std::count_if(centres.begin(), centres.end(), above);
  const bool all = count == static_cast<std::ptrdiff_t>(centres.size());
  // A plane has grains on its own side alone; one that lies behind it has no cell.
  if (all || !wall.finite()) bounds.planes.push_back({wall.point, wall.normal});
  if (count == 0 && wall.finite()) bounds.planes.push_back({wall.point, -wall.normal});
}

void add_cylinder(const Wall<3>& wall, const std::vector<Vec<3>>& centres, CellWalls& bounds) {
  const auto& line = wall.shape.corners;
  if (line[0][0] != line[1][0]) return;  // a cone or a ring
  const bool inside = std::all_of(centres.begin(), centres.end(), [&](const Vec<3>& centre) {
    return magnitude(tangential(Vec<3>(centre - wall.point), wall.normal)) < line[0][0];
  });
  if (inside) bounds.cylinders.push_back({wall.point, wall.normal, line[0][0]});
}

CellWalls bounds_of(const std::vector<RecordedWall<3>>& walls, const Grains<3>& grains,
                    const std::vector<bool>& in_heap) {
  std::vector<Vec<3>> centres;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) centres.push_back(grains.line[k].position);
  }
  CellWalls bounds;
  for (const auto& recorded : walls) {
    if (recorded.open || centres.empty()) continue;
    if (recorded.wall.shape.kind == Kind::frustum) {
      add_cylinder(recorded.wall, centres, bounds);
    } else {
      add_plane(recorded.wall, centres, bounds);
    }
  }
  return bounds;
}

}  // namespace

void add_stress(Moment<2>& moment, const std::vector<RecordedWall<2>>& walls, const Box<2>& box) {
  const auto in_heap = supported(*moment.grains, moment.contacts);
  const auto cells = voronoi(moment.grains, in_heap, standing_walls(walls), box);
  for (const auto& grain : grain_stresses(moment.grains, moment.contacts, cells, box)) {
    moment.stress.push_back(grain.stress);
    moment.extent.push_back(grain.area);
  }
}

void add_stress(Moment<3>& moment, const std::vector<RecordedWall<3>>& walls, const Box<3>& box) {
  const auto& grains = *moment.grains;
  const auto in_heap = supported(grains, moment.contacts);
  moment.stress.assign(grains.size(), {});
  for (const auto& grain : grains.line) {
    moment.extent.push_back(4.0 / 3.0 * std::numbers::pi * grain.radius * grain.radius * grain.radius);
  }
  for (const auto& cell : sphere_cells(moment.grains, in_heap, bounds_of(walls, grains, in_heap), box)) {
    if (cell.closed && cell.volume > 0.0) moment.extent[cell.place] = cell.volume;
  }
  const auto add = [&](std::size_t k, const Vec<3>& force, const Vec<3>& branch) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) moment.stress[k][static_cast<std::size_t>(3 * a + b)] += force[a] * branch[b];
    }
  };
  for (const auto& contact : moment.contacts.list) {
    const auto first = moment.grains.find(contact.first).value();
    const Vec<3> force = force_of(contact);
    const Vec<3> lever = contact.normal * contact.first_lever;
    add(first, force, lever);
    if (contact.second < 0) continue;
    const auto second = moment.grains.find(contact.second).value();
    add(second, -force, lever - separation(grains.line[first].position, grains.line[second].position, box));
  }
  for (std::size_t k = 0; k < grains.size(); ++k) {
    for (auto& component : moment.stress[k]) component /= moment.extent[k];
  }
}

}  // namespace repose
