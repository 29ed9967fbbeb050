// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace repose {

/// A moving grain at one moment of a track; single precision is ample for telling who has moved.
struct TrackedGrain {
  std::int64_t id = 0;
  float x = 0.0F;               ///< [L] brought into a periodic box
  float y = 0.0F;               ///< [L]
  float radius = 0.0F;          ///< [L]
  float kinetic_energy = 0.0F;  ///< [M L^2/T^2] translation and rotation
  bool in_heap = false;         ///< touches something
};

/// The moving grains, by ascending id, at one time.
struct TrackMoment {
  double time = 0.0;  ///< [T]
  std::vector<TrackedGrain> grains;
};

/// Where the moving grains were at regular moments of a run.
using Track = std::vector<TrackMoment>;

}  // namespace repose
