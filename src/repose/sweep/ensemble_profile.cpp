// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table.hpp"

#include <algorithm>
#include <limits>

namespace repose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double dip_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  return dip ? dip->index : none;
}

double max_over_centre_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  const auto ratio = dip ? max_over_centre(profile, dip->centre, dip->half_width) : std::nullopt;
  return ratio.value_or(none);
}

/// Mean profile of some members, without one of them.
BaseProfile mean_profile(const std::vector<const BaseProfile*>& members, std::size_t without) {
  BaseProfile mean = *members.front();
  std::fill(mean.normal.begin(), mean.normal.end(), 0.0);
  std::fill(mean.shear.begin(), mean.shear.end(), 0.0);
  double count = 0.0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (m == without) continue;
    count += 1.0;
    for (std::size_t k = 0; k < mean.x.size(); ++k) {
      mean.normal[k] += members[m]->normal[k];
      mean.shear[k] += members[m]->shear[k];
    }
  }
  for (std::size_t k = 0; k < mean.x.size(); ++k) {
    mean.normal[k] /= count;
    mean.shear[k] /= count;
  }
  return mean;
}

}  // namespace

std::optional<EnsembleProfile> ensemble_profile(const std::vector<const BaseProfile*>& members, double bin_width) {
  if (members.empty() || members.front()->x.empty()) return std::nullopt;
  for (const auto* member : members) {
    if (member->x != members.front()->x) return std::nullopt;
  }
  EnsembleProfile profile;
  profile.members = members.size();
  profile.mean = mean_profile(members, members.size());
  const auto over_members = [&](const auto& value) {
    std::vector<double> values;
    for (std::size_t m = 0; m < members.size(); ++m) values.push_back(value(m));
    return mean_of(values);
  };
  for (std::size_t k = 0; k < profile.mean.x.size(); ++k) {
    profile.normal_error.push_back(over_members([&](std::size_t m) { return members[m]->normal[k]; }).error);
    profile.shear_error.push_back(over_members([&](std::size_t m) { return members[m]->shear[k]; }).error);
  }
  profile.binned = binned(profile.mean, bin_width);
  std::vector<BinnedProfile> each;
  for (const auto* member : members) each.push_back(binned(*member, bin_width));
  for (std::size_t k = 0; k < profile.binned.x.size(); ++k) {
    profile.binned.normal_error[k] = over_members([&](std::size_t m) { return each[m].normal[k]; }).error;
    profile.binned.shear_error[k] = over_members([&](std::size_t m) { return each[m].shear[k]; }).error;
  }
  const auto of_mean = [&](double (*statistic)(const BaseProfile&)) {
    return jackknife(members.size(), [&](std::size_t without) { return statistic(mean_profile(members, without)); });
  };
  profile.dip_index = of_mean(dip_of);
  profile.max_over_centre = of_mean(max_over_centre_of);
  const auto dip = base_dip(profile.mean);
  profile.centre = dip ? dip->centre : none;
  profile.half_width = dip ? dip->half_width : none;
  return profile;
}

}  // namespace repose
