// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

/// A moving grain at one time of a track. Single precision suffices to find the grains that have moved.
template <int D>
struct TrackedGrain {
  std::int64_t id = 0;
  std::array<float, D> position{};  ///< [L] wrapped into a periodic box
  float radius = 0.0F;              ///< [L]
  float kinetic_energy = 0.0F;      ///< [M L^2/T^2] translation and rotation
  bool in_heap = false;             ///< whether it has a contact
};

/// The moving grains at one time, by ascending id.
template <int D>
struct TrackMoment {
  double time = 0.0;  ///< [T]
  std::vector<TrackedGrain<D>> grains;
};

/// The moving grains at regular times of a run.
template <int D>
using Track = std::vector<TrackMoment<D>>;

}  // namespace repose
