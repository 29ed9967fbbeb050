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
  double index = 0.0;       ///< see dip_index
  double centre = 0.0;      ///< [L] midway between the outermost loaded base grains
  double half_width = 0.0;  ///< [L] half the distance between them
};

/// Mean normal force over 0.15-0.45 of the half-width over the mean within 0.15 of the centre: a plateau gives 1, a dip
/// more, a full triangle (1 - 0.30)/(1 - 0.075) = 0.757. None where no base grain or no load lies there.
std::optional<double> dip_index(const BaseProfile& profile, double centre, double half_width);

/// Dip index of a profile over the stretch that it loads: where the running mean over five base grains exceeds 10 % of
/// its largest value. That cuts the tails off, so that a full triangle reads (1 - 0.27)/(1 - 0.0675) = 0.783. None
/// where fewer than five base grains or no load make it undefined.
std::optional<BaseDip> base_dip(const BaseProfile& profile);

/// Largest over central mean normal force, in rings of 0.15 half-widths about the centre (both sides together). Noise
/// lifts it: only for means over many heaps. None where the central ring holds no base grain or no load.
std::optional<double> max_over_centre(const BaseProfile& profile, double centre, double half_width);

/// How much the normal force scatters from one base grain to the next: root mean square of its deviation from the
/// running mean over five, over the mean normal force, within 0.75 of the half-width. None where `dip_index` is none.
std::optional<double> base_scatter(const BaseProfile& profile, double centre, double half_width);

/// Base forces in bins, edges at odd multiples of half the bin width, so that one bin is centred on x = 0.
struct BinnedProfile {
  double bin_width = 0.0;                         ///< [L]
  std::vector<double> x;                          ///< [L] centres of the bins that hold base grains
  std::vector<std::int64_t> count;                ///< of base grains
  std::vector<double> normal, shear;              ///< [grain weights] means
  std::vector<double> normal_error, shear_error;  ///< [grain weights] of the means, from the scatter; NaN for one grain
};
BinnedProfile binned(const BaseProfile& profile, double bin_width);

/// Running mean over `count` (odd) neighbours; shorter at the ends.
std::vector<double> running_mean(const std::vector<double>& values, std::size_t count);

}  // namespace repose
