// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/track.hpp"

#include <cstddef>
#include <vector>

namespace repose {

/// One interval between two moments of a track. Only grains that are in the heap at both moments count.
struct MotionRow {
  double start = 0.0;  ///< [T]
  double end = 0.0;    ///< [T]
  std::size_t grains = 0;
  std::size_t moved = 0;        ///< farther than MotionSettings::moved
  std::size_t moved_left = 0;   ///< of those, left of the apex
  double depth = 0.0;           ///< [L] of the moving layer, see measure_motion; NaN if nothing moved
  double kinetic_energy = 0.0;  ///< [M L^2/T^2] at the end
  double angle_left_deg = 0.0;  ///< of the surface at the end; NaN where no line could be drawn
  double angle_right_deg = 0.0;
};

/// A maximal run of intervals in which many grains moved.
struct Avalanche {
  double start = 0.0;     ///< [T]
  double end = 0.0;       ///< [T]
  std::size_t size = 0;   ///< distinct grains that moved
  double duration = 0.0;  ///< [T]
  double waiting = 0.0;   ///< [T] since the end of the one before; NaN for the first
  double depth = 0.0;     ///< [L] over all moves in it
  double left = 0.0;      ///< share of the moves left of the apex
};

/// A maximal run of intervals at whose ends the kinetic energy of the heap was high.
struct Burst {
  double start = 0.0;     ///< [T]
  double end = 0.0;       ///< [T]
  double duration = 0.0;  ///< [T]
  double waiting = 0.0;   ///< [T] as for avalanches
  double peak = 0.0;      ///< [M L^2/T^2] largest kinetic energy
};

struct MotionSettings {
  double moved = 0.0;        ///< [L] a grain that goes farther in an interval has moved
  std::size_t least = 1;     ///< grains that move in an interval of an avalanche
  double burst = 0.0;        ///< [M L^2/T^2] kinetic energy above which there is a burst
  double base_height = 0.0;  ///< [L]
  double bin_width = 0.0;    ///< [L] of the surface profile
};

struct Motion {
  std::vector<MotionRow> rows;
  std::vector<Avalanche> avalanches;
  std::vector<Burst> bursts;
};

/// What moved in a heap while it grew. The depth of a move is that of the grain's lowest point below the surface, at
/// right angles to the flank, at the start of the interval; the depth of a layer is the 90th percentile (the value of
/// rank ceil(0.9 n)) of the moves in it.
Motion measure_motion(const Track& track, const Box<2>& box, const MotionSettings& settings);

}  // namespace repose
