// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace repose {

/// Forces of the heap on each base grain, by ascending x, averaged over a stretch of time.
struct BaseProfile {
  std::vector<std::int64_t> id;
  std::vector<double> x;       ///< [L]
  std::vector<double> normal;  ///< [grain weights] positive downward
  std::vector<double> shear;   ///< [grain weights] positive to the right
  double window_start = 0.0;   ///< [T]
  double window_end = 0.0;     ///< [T]
};

/// Whether the load dips under the apex.
struct BaseDip {
  /// Mean normal force over 0.15-0.45 of the half-width over the mean within 0.15; a triangle gives 0.76, a plateau 1,
  /// a dip more than 1.
  double index = 0.0;
  double centre = 0.0;      ///< [L] midway between the outermost loaded base grains
  double half_width = 0.0;  ///< [L] half the distance between them
};

/// Dip index of a profile. Loaded: where the running mean over five base grains exceeds 10 % of its largest value.
/// None where fewer than five base grains or no load make it undefined.
std::optional<BaseDip> base_dip(const BaseProfile& profile);

/// Running mean over `count` (odd) neighbours; shorter at the ends.
std::vector<double> running_mean(const std::vector<double>& values, std::size_t count);

}  // namespace repose
