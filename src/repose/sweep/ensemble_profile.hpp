// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/inference.hpp"
#include "repose/sweep/ensemble_estimate.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// The base profile of an ensemble: means over the finished members, with standard errors from their scatter.
struct EnsembleProfile {
  std::size_t members = 0;
  BaseProfile mean;  ///< per base grain
  std::vector<double> normal_error, shear_error;
  BinnedProfile binned;        ///< errors between members
  EnsembleEstimate dip_index;  ///< of the mean profile, by the bootstrap over members
  EnsembleEstimate max_over_centre;
  double centre = 0.0, half_width = 0.0;  ///< [L] of the loaded interval of the mean profile; NaN without one
};

/// The ensemble profile of some members; none where they have no base, or bases that differ.
std::optional<EnsembleProfile> ensemble_profile(const std::vector<const BaseProfile*>& members, double bin_width);

/// A measure of a mean base profile: a ratio of means over an ensemble, not a mean of ratios.
struct ProfileMeasure {
  const char* name;
  double (*of)(const BaseProfile& mean);  ///< NaN where it is not defined
};
inline constexpr std::size_t profile_measure_count = 2;
/// "profile.dip_index" and "profile.max_over_centre".
const ProfileMeasure (&profile_measures())[profile_measure_count];

/// What members tell about a measure of their mean profile, by the bootstrap.
Inference inferred(const ProfileMeasure& measure, const std::vector<const BaseProfile*>& members);

/// The same of a difference, first less second. `paired`: members of the same seed stand at the same place of both
/// lists, and a resample has both or neither.
Inference inferred_difference(const ProfileMeasure& measure, const std::vector<const BaseProfile*>& first,
                              const std::vector<const BaseProfile*>& second, bool paired);

}  // namespace repose
