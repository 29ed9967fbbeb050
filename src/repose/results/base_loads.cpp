// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/base_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace repose {

namespace {

/// [L] The height of a wall that is flat and level and can carry grains; none of another.
std::optional<double> level_height(const RecordedWall<3>& standing) {
  constexpr double straight = 1e-9;
  const auto& wall = standing.wall;
  const double upright = wall.finite() ? std::fabs(wall.normal[2]) : wall.normal[2];  // a plane has one side
  if (standing.open || upright < 1.0 - straight) return std::nullopt;
  if (wall.shape.kind != WallShape<3>::Kind::frustum) return wall.point[2];
  const auto& [inner, outer, none] = wall.shape.corners;
  if (std::fabs(inner[1] - outer[1]) > straight * wall.half_length) return std::nullopt;
  return wall.point[2] + wall.normal[2] * inner[1];
}

/// Which walls are the floor.
std::vector<bool> floor_walls(const Record<3>& record) {
  std::vector<bool> floor(record.walls.size(), false);
  if (record.scene.base->wall(record.scene)) {
    floor[base_wall] = true;
    return floor;
  }
  std::vector<double> carried(record.walls.size(), 0.0);
  for (const auto& contact : record.contacts.list) {
    if (contact.second < 0) carried[static_cast<std::size_t>(-1 - contact.second)] += force_of(contact)[2];
  }
  std::vector<std::pair<double, std::size_t>> level;
  for (std::size_t w = 0; w < record.walls.size(); ++w) {
    if (const auto height = level_height(record.walls[w])) level.emplace_back(*height, w);
  }
  std::sort(level.begin(), level.end());
  const double one_height = 1e-6 * record.scene.grains.diameter;
  double most = 0.0;
  for (std::size_t begin = 0, end = 0; begin < level.size(); begin = end) {
    double load = 0.0;
    for (; end < level.size() && level[end].first - level[begin].first <= one_height; ++end) {
      load += carried[level[end].second];
    }
    if (!(load > most)) continue;
    most = load;
    std::fill(floor.begin(), floor.end(), false);
    for (std::size_t k = begin; k < end; ++k) floor[level[k].second] = true;
  }
  return floor;
}

}  // namespace

BaseLoads base_loads(const Record<3>& record) {
  const auto& scene = record.scene;
  const auto& base = record.base;
  if (scene.base->wall(scene) || base.x.empty()) {
    return {loads_on_walls(record.grains, record.contacts, floor_walls(record)), std::nullopt};
  }
  BaseLoads result;
  result.area_of_load = scene.base->area_of_grain();
  const double unit = scene.base_force_unit();
  for (std::size_t k = 0; k < base.x.size(); ++k) {
    const Vec<3> force{{base.shear[k], base.shear_y[k], -base.normal[k]}};
    result.loads.push_back({Vec<2>{{base.x[k], base.y[k]}}, force * unit});
  }
  return result;
}

}  // namespace repose
