// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"

#include <optional>
#include <vector>

namespace repose {

/// Distributions of the normal force and of the direction over the contacts above a force threshold.
struct ForceStatistics {
  double mean = 0.0;            ///< [M L/T^2] mean normal force of these contacts
  double bin_width = 0.0;       ///< of f, the normal force divided by its mean
  std::vector<double> f;        ///< centres of the bins, which begin at the threshold
  std::vector<double> density;  ///< P(f); its integral over all bins is 1
  std::vector<double> error;    ///< of the density, from the square root of the count

  /// Centres of bins of 5 degrees in [0, 180), from the horizontal. Lattices have contacts at multiples of 15 degrees,
  /// which are centres, not edges; the first bin is centred on the horizontal.
  std::vector<double> direction_deg;
  std::vector<double> direction_all;     ///< [1/deg] probability density over all these contacts
  std::vector<double> direction_strong;  ///< [1/deg] over those above the mean force; zero if there are none

  double sliding_fraction = 0.0;  ///< fraction of the contacts that are at the Coulomb limit
  double strong_fraction = 0.0;   ///< fraction of the contacts above the mean force
};

/// Measures the distributions over contacts with a finite normal force above `threshold` [M L/T^2]; none without such a
/// contact. Bins of f are 0.1 wide, or wider if the largest force would need more than 1000 of them.
std::optional<ForceStatistics> measure_force_statistics(const Contacts<2>& contacts, double threshold);

}  // namespace repose
