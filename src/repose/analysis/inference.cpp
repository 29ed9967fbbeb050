// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/inference.hpp"

#include "repose/analysis/statistics.hpp"
#include "repose/analysis/student.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// The value divided by its error; a value without error is surely off its bound, unless it equals it.
double ratio(double off, double error) {
  if (error > 0.0) return off / error;
  return off == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), off);
}

/// Interval and tests of a value with a known error and degrees of freedom.
void judge_by_t(Inference& inference) {
  const double reach = student_quantile(1.0 - test_level, inference.freedom) * inference.error;
  inference.low = ten_digits(inference.value - reach);
  inference.high = ten_digits(inference.value + reach);
  const auto p_value = [value = inference.value, error = inference.error, freedom = inference.freedom](double sign,
                                                                                                       double bound) {
    if (error == 0.0 && value == bound) return 1.0;
    return ten_digits(student_probability(-sign * ratio(value - bound, error), freedom));
  };
  inference.p_above = [p_value](double bound) { return p_value(1.0, bound); };
  inference.p_below = [p_value](double bound) { return p_value(-1.0, bound); };
}

}  // namespace

double satterthwaite(const std::vector<double>& variances, const std::vector<double>& freedoms) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    sum += variances[k];
    squares += variances[k] * variances[k] / freedoms[k];
  }
  return sum * sum / squares;
}

Inference mean_by_t(const std::vector<double>& values) {
  const auto estimate = mean_of(values);
  Inference inference;
  inference.test = "t";
  inference.count = estimate.count;
  inference.value = estimate.mean;
  if (estimate.count < 2) return inference;
  inference.error = estimate.error;
  inference.freedom = static_cast<double>(estimate.count - 1);
  judge_by_t(inference);
  return inference;
}

Inference value_by_t(double value, double error, double freedom) {
  Inference inference;
  inference.test = "t";
  inference.value = value;
  if (!(freedom > 0.0) || std::isnan(value) || std::isnan(error)) return inference;
  inference.error = error;
  inference.freedom = freedom;
  judge_by_t(inference);
  return inference;
}

Inference paired_difference(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) differences.push_back(first[k] - second[k]);
  auto inference = mean_by_t(differences);
  inference.test = "paired t";
  return inference;
}

Inference welch_difference(const std::vector<double>& first, const std::vector<double>& second) {
  const auto a = mean_of(first);
  const auto b = mean_of(second);
  Inference inference;
  inference.test = "Welch t";
  inference.count = a.count + b.count;
  inference.value = a.mean - b.mean;
  if (a.count < 2 || b.count < 2) return inference;
  inference.error = std::sqrt(a.error * a.error + b.error * b.error);
  const auto freedom_of = [](const Estimate& estimate) { return static_cast<double>(estimate.count - 1); };
  const double freedom = satterthwaite({a.error * a.error, b.error * b.error}, {freedom_of(a), freedom_of(b)});
  inference.freedom = std::isnan(freedom) ? std::min(freedom_of(a), freedom_of(b)) : freedom;
  judge_by_t(inference);
  return inference;
}

}  // namespace repose
