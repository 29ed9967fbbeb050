// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace repose {

/// A moving grain at one time of a track. Single precision suffices to find the grains that have moved.
struct TrackedGrain {
  std::int64_t id = 0;
  float x = 0.0F;               ///< [L] wrapped into a periodic box
  float y = 0.0F;               ///< [L]
  float radius = 0.0F;          ///< [L]
  float kinetic_energy = 0.0F;  ///< [M L^2/T^2] translation and rotation
  bool in_heap = false;         ///< whether it has a contact
};

/// The moving grains at one time, by ascending id.
struct TrackMoment {
  double time = 0.0;  ///< [T]
  std::vector<TrackedGrain> grains;
};

/// The moving grains at regular times of a run.
using Track = std::vector<TrackMoment>;

}  // namespace repose
