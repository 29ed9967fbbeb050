// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/flat_wall.hpp"
#include "repose/analysis/wall_span.hpp"
#include "repose/boundaries/wall.hpp"
#include "repose/methods/wall_crossings.hpp"
#include "repose/scene/scene.hpp"

#include <string>
#include <vector>

namespace repose {

/// A wall as it stands at the time of a record. Its place in the list is its number, which contacts name, so walls that
/// have opened stay in the list.
template <int D>
struct RecordedWall {
  std::string name;
  Vec<D> start{};        ///< [L] point of the wall at the start of the run
  Wall<D> wall;          ///< with its point and normal as they are at that time
  bool open = false;     ///< grains pass through it
  bool rotates = false;  ///< about the centre of its motion
  Crossings crossed;     ///< the grains that have gone through it, of a wall of finite length
};

/// Those that stand, as they bound cells and fields.
std::vector<FlatWall> standing_walls(const std::vector<RecordedWall<2>>& walls);

/// The span of each wall among those that stand; that of an open one has no length.
std::vector<WallSpan> spans_of(const std::vector<RecordedWall<2>>& walls, const Grains<2>& grains, const Box<2>& box);

/// The walls of a scene at some time. `states` has an entry for each, or none where all stand still.
template <int D = 2>
std::vector<RecordedWall<D>> recorded_walls(const Scene& scene, const std::vector<WallState>& states, double time);

}  // namespace repose
