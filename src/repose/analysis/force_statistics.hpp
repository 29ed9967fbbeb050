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
  /// In 3D instead: centres of 20 bins of |cos(theta)| in [0, 1], theta the angle of the normal from the vertical. They
  /// cover equal solid angles, so that the density is 1 everywhere for isotropic directions.
  std::vector<double> direction_cosine;
  std::vector<double> direction_all;     ///< [1/deg], in 3D []: probability density over all these contacts
  std::vector<double> direction_strong;  ///< likewise over those above the mean force; zero if there are none

  double sliding_fraction = 0.0;  ///< fraction of the contacts that are at the Coulomb limit
  double strong_fraction = 0.0;   ///< fraction of the contacts above the mean force
};

/// Measures the distributions over contacts with a finite normal force above `threshold` [M L/T^2]; none without such a
/// contact. Bins of f are 0.1 wide, or wider if the largest force would need more than 1000 of them.
/// Validated by tests/unit/force_statistics_exact_test.cpp and, in 3D, tests/unit/sphere_forces_test.cpp.
template <int D = 2>
std::optional<ForceStatistics> measure_force_statistics(const Contacts<D>& contacts, double threshold);

}  // namespace repose
