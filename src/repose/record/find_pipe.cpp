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

}  // namespace

Pipe PipeWalls::at(const std::vector<RecordedWall<2>>& walls) const {
  return {.left_wall = static_cast<std::int64_t>(left),
          .right_wall = static_cast<std::int64_t>(right),
          .left = walls[left].wall.point[0],
          .right = walls[right].wall.point[0],
          .floor = floor ? walls[*floor].wall.point[1] : 0.0};
}

std::optional<PipeWalls> find_pipe(const Scene& scene) {
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

}  // namespace repose
