// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace repose {

/// The values of a number of the base forces. NaN: has no bound, or is not defined.
struct AllowedRange {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double least = none;  ///< over all states of equilibrium
  double most = none;
  double cold = none;  ///< of the contact problem of the state, solved from zero impulses
  double warm = none;  ///< of the recorded forces
};

/// The range of the mean force in each bin of the base.
struct BinnedRange {
  double bin_width = 0.0;           ///< [L]
  std::vector<double> x;            ///< [L] centres of the bins
  std::vector<double> least, most;  ///< [grain weights]; NaN: has no bound
};

/// Which base forces static equilibrium allows at the places of a state of rigid grains: see
/// docs/physics/force_range.md.
struct ForceRange {
  std::string problem;                      ///< why there is no range; empty where there is one
  double contact_gap = AllowedRange::none;  ///< [mean diameters] nearer bodies touch
  std::int64_t contacts = 0;
  std::int64_t unknowns = 0;
  std::int64_t equations = 0;
  double unbalanced = AllowedRange::none;     ///< [grain weights] largest net force on a grain, as recorded
  double cold_residual = AllowedRange::none;  ///< [g dt] of the cold solution
  AllowedRange central_force;                 ///< [grain weights] mean over base grains within 0.15 half-widths
  AllowedRange dip;                           ///< dip index
  AllowedRange largest;                       ///< [grain weights] on any base grain
  AllowedRange load_ratio;                    ///< load of the floor of a column over its weight
  AllowedRange wall_ratio;                    ///< normal force on its two walls over its weight
  BinnedRange base;

  std::int64_t degree() const { return unknowns - equations; }
};

}  // namespace repose
