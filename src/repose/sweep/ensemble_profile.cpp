// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/ensemble_profile.hpp"

#include "repose/analysis/bootstrap.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/numbers.hpp"

#include <algorithm>
#include <limits>

namespace repose {

namespace {

double dip_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  return dip ? dip->index : no_number;
}

double max_over_centre_of(const BaseProfile& profile) {
  const auto dip = base_dip(profile);
  const auto ratio = dip ? max_over_centre(profile, dip->centre, dip->half_width) : std::nullopt;
  return ratio.value_or(no_number);
}

/// The mean profile of members with weights.
class WeightedMean {
 public:
  explicit WeightedMean(const std::vector<const BaseProfile*>& members) : members_(members), mean_(*members.front()) {}

  /// The weights of the members begin at `first`.
  const BaseProfile& operator()(const std::vector<double>& weights, std::size_t first = 0) {
    std::fill(mean_.normal.begin(), mean_.normal.end(), 0.0);
    std::fill(mean_.shear.begin(), mean_.shear.end(), 0.0);
    double sum = 0.0;
    for (std::size_t m = 0; m < members_.size(); ++m) {
      const double weight = weights[first + m];
      if (weight == 0.0) continue;
      sum += weight;
      for (std::size_t k = 0; k < mean_.x.size(); ++k) {
        mean_.normal[k] += weight * members_[m]->normal[k];
        mean_.shear[k] += weight * members_[m]->shear[k];
      }
    }
    for (std::size_t k = 0; k < mean_.x.size(); ++k) {
      mean_.normal[k] /= sum;
      mean_.shear[k] /= sum;
    }
    return mean_;
  }

 private:
  const std::vector<const BaseProfile*>& members_;
  BaseProfile mean_;
};

constexpr ProfileMeasure all_measures[profile_measure_count] = {{"profile.dip_index", dip_of},
                                                                {"profile.max_over_centre", max_over_centre_of}};

}  // namespace

const ProfileMeasure (&profile_measures())[profile_measure_count] { return all_measures; }

Inference inferred(const ProfileMeasure& measure, const std::vector<const BaseProfile*>& members) {
  WeightedMean mean(members);
  return bootstrap({{members.size()}, [&](const std::vector<double>& weights) { return measure.of(mean(weights)); }},
                   "bootstrap");
}

Inference inferred_difference(const ProfileMeasure& measure, const std::vector<const BaseProfile*>& first,
                              const std::vector<const BaseProfile*>& second, bool paired) {
  WeightedMean first_mean(first);
  WeightedMean second_mean(second);
  const std::size_t second_place = paired ? 0 : first.size();
  const auto difference = [&](const std::vector<double>& weights) {
    return measure.of(first_mean(weights)) - measure.of(second_mean(weights, second_place));
  };
  if (paired) return bootstrap({{first.size()}, difference}, "paired bootstrap");
  return bootstrap({{first.size(), second.size()}, difference}, "unpaired bootstrap");
}

std::optional<EnsembleProfile> ensemble_profile(const std::vector<const BaseProfile*>& members, double bin_width) {
  if (members.empty() || members.front()->x.empty()) return std::nullopt;
  for (const auto* member : members) {
    if (member->x != members.front()->x) return std::nullopt;
  }
  EnsembleProfile profile;
  profile.members = members.size();
  profile.mean = WeightedMean(members)(std::vector<double>(members.size(), 1.0));
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
  const auto of_mean = [&](const ProfileMeasure& measure) {
    return estimate_of(inferred(measure, members), no_number, members.size());
  };
  profile.dip_index = of_mean(all_measures[0]);
  profile.max_over_centre = of_mean(all_measures[1]);
  const auto dip = base_dip(profile.mean);
  profile.centre = dip ? dip->centre : no_number;
  profile.half_width = dip ? dip->half_width : no_number;
  return profile;
}

}  // namespace repose
