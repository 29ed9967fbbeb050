// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/pipe.hpp"
#include "repose/record/recorded_wall.hpp"
#include "repose/scene/scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// The numbers of the walls of a pipe.
struct PipeWalls {
  std::size_t left = 0;
  std::size_t right = 0;
  std::optional<std::size_t> floor;  ///< the lowest level wall; none: base grains at height 0

  /// Where they stand.
  Pipe at(const std::vector<RecordedWall<2>>& walls) const;
};

/// The pipe of a scene: it has two upright walls, which face each other, and a level wall or base grains between them.
/// None where the box is periodic, or where a wall slopes or turns. Validated by tests/unit/pipe_test.cpp.
std::optional<PipeWalls> find_pipe(const Scene& scene);

}  // namespace repose
