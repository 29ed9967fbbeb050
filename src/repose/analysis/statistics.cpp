// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/statistics.hpp"

#include "repose/core/numbers.hpp"

#include <cmath>
#include <limits>

namespace repose {

namespace {}  // namespace

Estimate mean_of(const std::vector<double>& values) {
  Estimate estimate{0, no_number, no_number, no_number};
  double sum = 0.0;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    sum += x;
    ++estimate.count;
  }
  if (estimate.count == 0) return estimate;
  const auto n = static_cast<double>(estimate.count);
  estimate.mean = sum / n;
  if (estimate.count < 2) return estimate;
  double squares = 0.0;
  for (const double x : values) {
    if (!std::isnan(x)) squares += (x - estimate.mean) * (x - estimate.mean);
  }
  estimate.deviation = std::sqrt(squares / (n - 1.0));
  estimate.error = estimate.deviation / std::sqrt(n);
  return estimate;
}

Estimate jackknife(std::size_t count, const std::function<double(std::size_t without)>& statistic) {
  Estimate estimate{count, statistic(count), no_number, no_number};
  if (count < 2) return estimate;
  const auto n = static_cast<double>(count);
  std::vector<double> values;
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    values.push_back(statistic(k));
    sum += values.back();
  }
  double squares = 0.0;
  for (const double x : values) squares += (x - sum / n) * (x - sum / n);
  estimate.error = std::sqrt(squares * (n - 1.0) / n);
  return estimate;
}

}  // namespace repose
