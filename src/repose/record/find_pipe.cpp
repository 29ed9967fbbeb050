// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/find_pipe.hpp"

#include "repose/scene/geometry.hpp"

#include <cmath>
#include <utility>

namespace repose {

namespace {

constexpr double rounding = 1e-9;  // of a normal

bool faces(const Wall<2>& wall, const Vec<2>& direction) {
  const double part = dot(wall.normal, direction);
  return (wall.finite() ? std::fabs(part) : part) > 1.0 - rounding;
}

bool is_upright(const Vec<3>& direction) { return std::fabs(direction[2]) > 1.0 - rounding; }

bool is_cylinder(const Wall<3>& wall) {
  const auto& ends = wall.shape.corners;
  return wall.shape.kind == WallShape<3>::Kind::frustum && is_upright(wall.normal) &&
         std::fabs(ends[0][0] - ends[1][0]) < rounding * ends[0][0];
}

bool is_level(const Wall<3>& wall) {
  const auto& ends = wall.shape.corners;
  const bool flat = wall.shape.kind != WallShape<3>::Kind::frustum || ends[0][1] == ends[1][1];
  return flat && is_upright(wall.normal);
}

/// Whether a level wall covers a part of the cross-section of a cylinder, below its upper end, with grains above.
bool lies_under(const Wall<3>& level, const Wall<3>& cylinder) {
  if (!level.finite() && level.normal[2] < 0.0) return false;
  if (level.point[2] >= cylinder.point[2] + std::fabs(cylinder.shape.corners[1][1])) return false;
  const Vec<3> from_point{{cylinder.point[0] - level.point[0], cylinder.point[1] - level.point[1], 0.0}};
  return above(level, wall_now(level, {}, 0.0), from_point).height < cylinder.shape.corners[0][0];
}

}  // namespace

Pipe WallsOfPipe<2>::at(const std::vector<RecordedWall<2>>& walls) const {
  return {.left_wall = static_cast<std::int64_t>(left),
          .right_wall = static_cast<std::int64_t>(right),
          .left = walls[left].wall.point[0],
          .right = walls[right].wall.point[0],
          .floor = floor ? walls[*floor].wall.point[1] : 0.0};
}

CylinderPipe WallsOfPipe<3>::at(const std::vector<RecordedWall<3>>& walls) const {
  const auto& cylinder = walls[side].wall;
  return {.wall = static_cast<std::int64_t>(side),
          .axis = {{cylinder.point[0], cylinder.point[1]}},
          .radius = cylinder.shape.corners[0][0],
          .floor = floor ? walls[*floor].wall.point[2] : 0.0};
}

template <>
std::optional<WallsOfPipe<2>> find_pipe(const Scene& scene) {
  if (scene.box.periodic()) return std::nullopt;
  const auto walls = make_walls(scene);
  std::vector<std::size_t> upright;
  std::optional<std::size_t> floor;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto& wall = walls[w];
    if (wall.motion.turns()) return std::nullopt;
    if (std::fabs(wall.normal[0]) > 1.0 - rounding) {
      upright.push_back(w);
    } else if (std::fabs(wall.normal[0]) > rounding) {
      return std::nullopt;
    } else if (faces(wall, {{0.0, 1.0}}) && (!floor || wall.point[1] < walls[*floor].point[1])) {
      floor = w;
    }
  }
  if (upright.size() != 2) return std::nullopt;
  if (walls[upright[0]].point[0] > walls[upright[1]].point[0]) std::swap(upright[0], upright[1]);
  const PipeWalls pipe{upright[0], upright[1], floor};
  const bool facing = faces(walls[pipe.left], {{1.0, 0.0}}) && faces(walls[pipe.right], {{-1.0, 0.0}});
  const bool apart = walls[pipe.left].point[0] < walls[pipe.right].point[0];
  if (!facing || !apart || (!floor && !scene.base->of_grains())) return std::nullopt;
  return pipe;
}

template <>
std::optional<WallsOfPipe<3>> find_pipe(const Scene& scene) {
  if (scene.box.periodic() || scene.box.periodic_y()) return std::nullopt;
  const auto gravity = scene.gravity_vector<3>();
  if (gravity[0] != 0.0 || gravity[1] != 0.0) return std::nullopt;
  const auto walls = make_walls<3>(scene);
  std::optional<std::size_t> side;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (walls[w].motion.turns()) return std::nullopt;
    if (is_level(walls[w])) continue;
    if (side || !is_cylinder(walls[w])) return std::nullopt;
    side = w;
  }
  if (!side) return std::nullopt;
  WallsOfPipe<3> pipe{*side, std::nullopt};
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (w == *side || !lies_under(walls[w], walls[*side])) continue;
    if (!pipe.floor || walls[w].point[2] < walls[*pipe.floor].point[2]) pipe.floor = w;
  }
  if (!pipe.floor && !scene.base->of_grains()) return std::nullopt;
  return pipe;
}

}  // namespace repose
