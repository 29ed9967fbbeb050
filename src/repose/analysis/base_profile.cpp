// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_profile.hpp"

#include "repose/analysis/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace repose {

namespace {

constexpr std::size_t smoothing = 5;  // base grains

}  // namespace

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

DipZone dip_zone(double x, double centre, double half_width) {
  const double place = std::fabs(x - centre) / half_width;
  if (place <= 0.15) return DipZone::inner;
  return place <= 0.45 ? DipZone::outer : DipZone::beyond;
}

std::optional<double> dip_index(const BaseProfile& profile, double centre, double half_width) {
  double inner = 0.0;
  double outer = 0.0;
  double inner_count = 0.0;
  double outer_count = 0.0;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    const auto zone = dip_zone(profile.x[k], centre, half_width);
    if (zone == DipZone::inner) {
      inner += profile.normal[k];
      inner_count += 1.0;
    } else if (zone == DipZone::outer) {
      outer += profile.normal[k];
      outer_count += 1.0;
    }
  }
  if (inner_count == 0.0 || outer_count == 0.0 || !(inner > 0.0)) return std::nullopt;
  return (outer / outer_count) / (inner / inner_count);
}

std::optional<BaseDip> base_dip(const BaseProfile& profile) {
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
  const auto index = dip_index(profile, dip.centre, dip.half_width);
  if (!index) return std::nullopt;
  dip.index = *index;
  return dip;
}

std::optional<double> max_over_centre(const BaseProfile& profile, double centre, double half_width) {
  constexpr double ring = 0.15;
  constexpr std::size_t rings = 7;  // the last one ends a little beyond the half-width
  std::array<double, rings> sum{};
  std::array<double, rings> count{};
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    const double place = std::fabs(profile.x[k] - centre) / half_width;
    if (!(place < ring * rings)) continue;
    const auto at = std::min(static_cast<std::size_t>(place / ring), rings - 1);
    sum[at] += profile.normal[k];
    count[at] += 1.0;
  }
  if (count[0] == 0.0 || !(sum[0] > 0.0)) return std::nullopt;
  double largest = 0.0;
  for (std::size_t k = 0; k < rings; ++k) {
    if (count[k] > 0.0) largest = std::max(largest, sum[k] / count[k]);
  }
  return largest / (sum[0] / count[0]);
}

std::optional<double> base_scatter(const BaseProfile& profile, double centre, double half_width) {
  constexpr double within = 0.75;
  const auto smooth = running_mean(profile.normal, smoothing);
  double squares = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    if (std::fabs(profile.x[k] - centre) > within * half_width) continue;
    squares += (profile.normal[k] - smooth[k]) * (profile.normal[k] - smooth[k]);
    sum += profile.normal[k];
    count += 1.0;
  }
  if (count == 0.0 || !(sum > 0.0)) return std::nullopt;
  return std::sqrt(squares / count) / (sum / count);
}

long base_bin(double x, double bin_width) { return static_cast<long>(std::floor(x / bin_width + 0.5)); }

BinnedProfile binned(const BaseProfile& profile, double bin_width) {
  std::map<long, std::vector<std::size_t>> bins;
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    bins[base_bin(profile.x[k], bin_width)].push_back(k);
  }
  BinnedProfile result;
  result.bin_width = bin_width;
  for (const auto& entry : bins) {
    const auto& members = entry.second;
    result.x.push_back(static_cast<double>(entry.first) * bin_width);
    result.count.push_back(static_cast<std::int64_t>(members.size()));
    const auto pick = [&](const std::vector<double>& values) {
      std::vector<double> chosen;
      for (const auto k : members) chosen.push_back(values[k]);
      return mean_of(chosen);
    };
    const auto normal = pick(profile.normal);
    const auto shear = pick(profile.shear);
    result.normal.push_back(normal.mean);
    result.normal_error.push_back(normal.error);
    result.shear.push_back(shear.mean);
    result.shear_error.push_back(shear.error);
  }
  return result;
}

}  // namespace repose
