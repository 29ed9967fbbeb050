// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace repose {

/// Forces of the heap on each base grain, by ascending x, averaged over an interval of time. Where the base is a plane:
/// of each grain that it carries, at one time.
struct BaseProfile {
  std::vector<std::int64_t> id;
  std::vector<double> x;        ///< [L]
  std::vector<double> normal;   ///< [grain weights] positive downward
  std::vector<double> shear;    ///< [grain weights] positive to the right
  std::vector<double> y;        ///< [L] in three dimensions, else empty
  std::vector<double> shear_y;  ///< [grain weights] along y in three dimensions, else empty
  double window_start = 0.0;    ///< [T] start of the interval
  double window_end = 0.0;      ///< [T] its end
};

/// The dip of the load under the apex.
struct BaseDip {
  double index = 0.0;       ///< see dip_index
  double centre = 0.0;      ///< [L] midway between the outermost loaded base grains
  double half_width = 0.0;  ///< [L] half the distance between them
};

/// The part of the base that a place belongs to: within 0.15 half-widths of the centre, or beyond that within 0.45.
enum class DipZone { inner, outer, beyond };
DipZone dip_zone(double x, double centre, double half_width);

/// The dip index: mean normal force at 0.15 to 0.45 half-widths from the centre, divided by the mean within 0.15. It is
/// 1 for a plateau, above 1 for a dip, (1 - 0.30)/(1 - 0.075) = 0.757 for a full triangle. None without a base grain or
/// load in one of the two ranges.
std::optional<double> dip_index(const BaseProfile& profile, double centre, double half_width);

/// The dip index over the loaded width: where the running mean over five base grains exceeds 10 % of its largest value.
/// This cuts off the tails, so that a full triangle gives (1 - 0.27)/(1 - 0.0675) = 0.783. None with fewer than five
/// base grains or without load.
std::optional<BaseDip> base_dip(const BaseProfile& profile);

/// The largest mean normal force divided by the central one, in rings of 0.15 half-widths about the centre (both sides
/// together). Noise increases it, so it is meant for means over many heaps. None if the central ring holds no base
/// grain or no load.
std::optional<double> max_over_centre(const BaseProfile& profile, double centre, double half_width);

/// The scatter of the normal force from one base grain to the next: root mean square deviation from the running mean
/// over five grains, divided by the mean normal force, within 0.75 of the half-width. None without a base grain or load
/// there.
std::optional<double> base_scatter(const BaseProfile& profile, double centre, double half_width);

/// Base forces in bins. Bin edges lie at odd multiples of half the bin width, so that one bin is centred on x = 0.
struct BinnedProfile {
  double bin_width = 0.0;                         ///< [L]
  std::vector<double> x;                          ///< [L] centres of the bins that hold base grains
  std::vector<std::int64_t> count;                ///< number of base grains
  std::vector<double> normal, shear;              ///< [grain weights] means
  std::vector<double> normal_error, shear_error;  ///< [grain weights] standard errors of the means; NaN for one grain
};
/// The number of the bin that a place is in.
long base_bin(double x, double bin_width);
BinnedProfile binned(const BaseProfile& profile, double bin_width);

/// Running mean over `count` (odd) neighbouring values, and over fewer at the ends.
std::vector<double> running_mean(const std::vector<double>& values, std::size_t count);

}  // namespace repose
