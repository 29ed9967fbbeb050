// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/track.hpp"

#include <cstddef>
#include <vector>

namespace repose {

/// One interval between two times of a track. Only grains that are in the heap at both times count.
struct MotionRow {
  double start = 0.0;  ///< [T]
  double end = 0.0;    ///< [T]
  std::size_t grains = 0;
  std::size_t moved = 0;        ///< grains displaced by more than MotionSettings::moved
  std::size_t moved_left = 0;   ///< those of them that were left of the apex
  double depth = 0.0;           ///< [L] depth of the moving layer, see measure_motion; NaN if nothing moved
  double kinetic_energy = 0.0;  ///< [M L^2/T^2] at the end
  double angle_left_deg = 0.0;  ///< angle of the left flank at the end; NaN if no line could be fitted
  double angle_right_deg = 0.0;
};

/// An avalanche: a maximal sequence of intervals in which many grains moved.
struct Avalanche {
  double start = 0.0;     ///< [T]
  double end = 0.0;       ///< [T]
  std::size_t size = 0;   ///< number of distinct grains that moved
  double duration = 0.0;  ///< [T]
  double waiting = 0.0;   ///< [T] time since the end of the previous avalanche; NaN for the first
  double depth = 0.0;     ///< [L] depth of the moving layer over all its moves
  double left = 0.0;      ///< fraction of the moves left of the apex
};

/// A burst: a maximal sequence of intervals at whose ends the kinetic energy of the heap was high.
struct Burst {
  double start = 0.0;     ///< [T]
  double end = 0.0;       ///< [T]
  double duration = 0.0;  ///< [T]
  double waiting = 0.0;   ///< [T] time since the end of the previous burst; NaN for the first
  double peak = 0.0;      ///< [M L^2/T^2] largest kinetic energy
};

struct MotionSettings {
  double moved = 0.0;        ///< [L] a grain has moved if it is displaced by more than this in an interval
  std::size_t least = 1;     ///< smallest number of grains that move in an interval of an avalanche
  double burst = 0.0;        ///< [M L^2/T^2] kinetic energy above which an interval belongs to a burst
  double base_height = 0.0;  ///< [L] y of the base centres
  double bin_width = 0.0;    ///< [L] of the surface profile
};

struct Motion {
  std::vector<MotionRow> rows;
  std::vector<Avalanche> avalanches;
  std::vector<Burst> bursts;
};

/// Measures the motion in a heap while it grows. The depth of a move is the depth of the grain's lowest point below the
/// surface, perpendicular to the flank, at the start of the interval. The depth of a moving layer is the 90th
/// percentile (the value of rank ceil(0.9 n)) of its moves.
Motion measure_motion(const Track<2>& track, const Box<2>& box, const MotionSettings& settings);

}  // namespace repose
