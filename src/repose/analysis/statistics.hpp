// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace repose {

/// The mean of a sample and its errors.
struct Estimate {
  std::size_t count = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the sample (n - 1); NaN for fewer than two
  double error = 0.0;      ///< standard error of the mean; NaN for fewer than two
};

/// Mean and errors of the values; NaNs are left out. All NaN without values.
Estimate mean_of(const std::vector<double>& values);

/// A statistic of a sample and its standard error by the jackknife. `statistic(k)` is its value without member k,
/// `statistic(count)` that of all members. The error is NaN for fewer than two members.
Estimate jackknife(std::size_t count, const std::function<double(std::size_t without)>& statistic);

}  // namespace repose
