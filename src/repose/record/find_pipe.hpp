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
template <int D>
struct WallsOfPipe;

/// Two upright walls.
template <>
struct WallsOfPipe<2> {
  std::size_t left = 0;
  std::size_t right = 0;
  std::optional<std::size_t> floor;  ///< the lowest level wall; none: base grains at height 0

  bool is_side(std::size_t wall) const { return wall == left || wall == right; }
  /// Where they stand.
  Pipe at(const std::vector<RecordedWall<2>>& walls) const;
};
using PipeWalls = WallsOfPipe<2>;

/// An upright cylinder.
template <>
struct WallsOfPipe<3> {
  std::size_t side = 0;              ///< the cylinder
  std::optional<std::size_t> floor;  ///< the lowest level wall in it; none: base grains at height 0

  bool is_side(std::size_t wall) const { return wall == side; }
  /// Where they stand.
  CylinderPipe at(const std::vector<RecordedWall<3>>& walls) const;
};

/// The pipe of a scene. In 2D it has two upright walls, which face each other, and a level wall or base grains between
/// them. In 3D it has one cylinder, which is upright, and a level wall or base grains in it: the wall covers a part of
/// the cross-section below the upper end of the cylinder. None where the box is periodic, where a wall slopes or turns,
/// or, in 3D, where another wall is upright or gravity is not. Validated by tests/unit/pipe_test.cpp and
/// tests/unit/find_cylinder_test.cpp.
template <int D = 2>
std::optional<WallsOfPipe<D>> find_pipe(const Scene& scene);
template <>
std::optional<WallsOfPipe<2>> find_pipe(const Scene& scene);
template <>
std::optional<WallsOfPipe<3>> find_pipe(const Scene& scene);

}  // namespace repose
