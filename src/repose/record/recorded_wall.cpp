// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/recorded_wall.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/geometry.hpp"

namespace repose {

std::vector<RecordedWall> recorded_walls(const Scene& scene, const std::vector<WallState>& states, double time) {
  const auto walls = make_walls(scene);
  const auto names = wall_names(scene);
  REPOSE_ASSERT(states.empty() || states.size() == walls.size());
  std::vector<RecordedWall> recorded;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto now = wall_now(walls[w], states.empty() ? WallState{} : states[w], time);
    recorded.push_back({names[w], walls[w].point, walls[w], !now.present});
    recorded.back().wall.point = now.point;
  }
  return recorded;
}

}  // namespace repose
