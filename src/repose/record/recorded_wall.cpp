// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/recorded_wall.hpp"

#include "repose/scene/geometry.hpp"

namespace repose {

std::vector<FlatWall> standing_walls(const std::vector<RecordedWall>& walls) {
  std::vector<FlatWall> standing;
  for (const auto& recorded : walls) {
    if (!recorded.open) standing.push_back({recorded.wall.point, recorded.wall.normal, recorded.wall.half_length});
  }
  return standing;
}

std::vector<WallSpan> spans_of(const std::vector<RecordedWall>& walls, const Grains<2>& grains, const Box<2>& box) {
  const auto standing = wall_spans(standing_walls(walls), grains, box);
  std::vector<WallSpan> spans;
  std::size_t next = 0;
  for (const auto& wall : walls) spans.push_back(wall.open ? WallSpan{wall.wall.point, 0.0} : standing[next++]);
  return spans;
}

std::vector<RecordedWall> recorded_walls(const Scene& scene, const std::vector<WallState>& states, double time) {
  const auto walls = make_walls(scene);
  const auto names = wall_names(scene);
  const auto now = walls_at(walls, states, time);
  std::vector<RecordedWall> recorded;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    recorded.push_back({names[w], walls[w].point, walls[w], !now[w].present, false, {}});
    recorded.back().wall.point = now[w].point;
    recorded.back().wall.normal = now[w].normal;
    recorded.back().rotates = walls[w].motion.kind == WallMotion<2>::Kind::rotation;
  }
  return recorded;
}

}  // namespace repose
