// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace repose {

/// One level decides everything: an interval holds the true value with probability 95 %, and each one-sided test is
/// made at half the rest, so that a bound is excluded where it lies outside the interval.
inline constexpr double test_level = 0.025;
inline constexpr double interval_probability = 1.0 - 2.0 * test_level;

/// A statistic of a sample and what the sample tells about its true value. All NaN, without tests, for fewer than two
/// members.
struct Inference {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string test;       ///< "t", "paired t", "Welch t", "bootstrap", "paired bootstrap" or "unpaired bootstrap"
  std::size_t count = 0;  ///< members; pairs of them where they are paired
  double value = none;
  double error = none;             ///< standard error
  double bias = none;              ///< expected value less the true one, estimated; NaN for means, which have none
  double freedom = none;           ///< degrees of freedom of Student's t
  double low = none, high = none;  ///< ends of the interval
  std::function<double(double)> p_above;  ///< one-sided p-value by which the true value is above a bound
  std::function<double(double)> p_below;  ///< the same for below
};

/// The mean of a sample by Student's t. NaNs are left out.
Inference mean_by_t(const std::vector<double>& values);

/// A value with its standard error, by Student's t with these degrees of freedom.
Inference value_by_t(double value, double error, double freedom);

/// The mean of first[k] - second[k], values of the same seed, by Student's t. Pairs with a NaN are left out.
Inference paired_difference(const std::vector<double>& first, const std::vector<double>& second);

/// The difference of the means of two independent samples by Welch's t, with degrees of freedom by Satterthwaite's
/// formula (Welch 1947, Biometrika 34, 28). NaNs are left out.
/// All three are validated by tests/unit/inference_test.cpp.
Inference welch_difference(const std::vector<double>& first, const std::vector<double>& second);

/// Degrees of freedom of a sum of independent estimated variances, each with its own; NaN if all variances are 0.
double satterthwaite(const std::vector<double>& variances, const std::vector<double>& freedoms);

}  // namespace repose
