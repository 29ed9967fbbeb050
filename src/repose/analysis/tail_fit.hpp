// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace repose {

/// Another law for the same tail. Ratios are of likelihoods: of the power law over the other, as a logarithm.
struct RivalLaw {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double log_ratio = none;  ///< above 0: the power law is likelier
  double p_value = none;    ///< that chance alone makes a ratio as far from 0
};

/// The distribution of the sizes of events: a power law p(x) ~ x^-exponent from `x_min` on, by maximum likelihood, and
/// what speaks for and against it. Source: Clauset, Shalizi and Newman, SIAM Rev. 51 (2009) 661; docs/physics/slips.md.
/// Validated by tests/unit/tail_fit_test.cpp.
struct TailFit {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::int64_t events = 0;  ///< with a size above 0
  std::int64_t tail = 0;    ///< of them with a size of at least x_min
  double x_min = none;      ///< in the unit of the sizes: where the law begins, by the smallest Kolmogorov distance
  double exponent = none;
  double error = none;     ///< standard error, (exponent - 1)/sqrt(tail), for a given x_min
  double decades = none;   ///< log10 of the largest size over x_min
  double distance = none;  ///< of Kolmogorov and Smirnov, between the tail and the law
  double p_value = none;   ///< fraction of synthetic samples of the law that lie farther from their own fit
  RivalLaw exponential;    ///< by Vuong's test, two-sided
  RivalLaw log_normal;     ///< of which the power law is a limit: ratio at most 0, one-sided
  std::string verdict;     ///< "power law", or why it is not claimed
};

/// How many events and how many decades a power law needs before it is claimed.
inline constexpr std::int64_t least_events_of_power_law = 10000;
inline constexpr double least_decades_of_power_law = 2.0;
/// Synthetic samples for the p-value.
inline constexpr int synthetic_samples = 100;

/// Without fit where fewer than fifty sizes are above 0, or all are equal. The p-value takes nearly all of the time,
/// and is NaN without `synthetic` samples.
TailFit fit_tail(const std::vector<double>& sizes, int synthetic = synthetic_samples);

}  // namespace repose
