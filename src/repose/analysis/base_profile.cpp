// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_profile.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

std::vector<double> running_mean(const std::vector<double>& values, std::size_t count) {
  const std::size_t half = count / 2;
  std::vector<double> means(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t first = k < half ? 0 : k - half;
    const std::size_t last = std::min(values.size(), k + half + 1);
    double sum = 0.0;
    for (auto m = first; m < last; ++m) sum += values[m];
    means[k] = sum / static_cast<double>(last - first);
  }
  return means;
}

std::optional<BaseDip> base_dip(const BaseProfile& profile) {
  constexpr std::size_t smoothing = 5;
  if (profile.normal.size() < smoothing) return std::nullopt;
  const auto smooth = running_mean(profile.normal, smoothing);
  const double largest = *std::max_element(smooth.begin(), smooth.end());
  if (!(largest > 0.0)) return std::nullopt;
  const auto loaded = [&](double force) { return force > 0.1 * largest; };
  const auto first = std::find_if(smooth.begin(), smooth.end(), loaded) - smooth.begin();
  const auto last = smooth.rend() - std::find_if(smooth.rbegin(), smooth.rend(), loaded) - 1;
  BaseDip dip;
  dip.centre = 0.5 * (profile.x[static_cast<std::size_t>(first)] + profile.x[static_cast<std::size_t>(last)]);
  dip.half_width = 0.5 * (profile.x[static_cast<std::size_t>(last)] - profile.x[static_cast<std::size_t>(first)]);
  double inner = 0.0;
  double outer = 0.0;
  double inner_count = 0.0;
  double outer_count = 0.0;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    const double place = std::fabs(profile.x[k] - dip.centre) / dip.half_width;
    if (place <= 0.15) {
      inner += profile.normal[k];
      inner_count += 1.0;
    } else if (place <= 0.45) {
      outer += profile.normal[k];
      outer_count += 1.0;
    }
  }
  if (inner_count == 0.0 || outer_count == 0.0 || !(inner > 0.0)) return std::nullopt;
  dip.index = (outer / outer_count) / (inner / inner_count);
  return dip;
}

}  // namespace repose
