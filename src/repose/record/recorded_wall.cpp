// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/recorded_wall.hpp"

#include "repose/scene/geometry.hpp"

namespace repose {

std::vector<FlatWall> standing_walls(const std::vector<RecordedWall<2>>& walls) {
  std::vector<FlatWall> standing;
  for (const auto& recorded : walls) {
    if (!recorded.open) standing.push_back({recorded.wall.point, recorded.wall.normal, recorded.wall.half_length});
  }
  return standing;
}

std::vector<WallSpan> spans_of(const std::vector<RecordedWall<2>>& walls, const Grains<2>& grains, const Box<2>& box) {
  const auto standing = wall_spans(standing_walls(walls), grains, box);
  std::vector<WallSpan> spans;
  std::size_t next = 0;
  for (const auto& wall : walls) spans.push_back(wall.open ? WallSpan{wall.wall.point, 0.0} : standing[next++]);
  return spans;
}

template <int D>
std::vector<RecordedWall<D>> recorded_walls(const Scene& scene, const std::vector<WallState>& states, double time) {
  const auto walls = make_walls<D>(scene);
  const auto names = wall_names(scene);
  const auto now = walls_at(walls, states, time);
  std::vector<RecordedWall<D>> recorded;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    recorded.push_back({names[w], walls[w].point, walls[w], !now[w].present, false, {}});
    recorded.back().wall.point = now[w].point;
    recorded.back().wall.normal = now[w].normal;
    if constexpr (D == 3) recorded.back().wall.shape.side = now[w].side;
    recorded.back().rotates = walls[w].motion.kind == WallMotion<D>::Kind::rotation;
  }
  return recorded;
}

template std::vector<RecordedWall<2>> recorded_walls(const Scene&, const std::vector<WallState>&, double);
template std::vector<RecordedWall<3>> recorded_walls(const Scene&, const std::vector<WallState>&, double);

}  // namespace repose
