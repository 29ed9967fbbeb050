// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace repose {

/// How the diameters of grains are distributed by number. A diameter is `quantile(u)` of a uniform number u, so that
/// sizes are as random, and as reproducible, as the numbers are. Validated by tests/unit/size_distribution_test.cpp.
class SizeDistribution {
 public:
  static SizeDistribution fixed(double diameter);
  static SizeDistribution uniform(double low, double high);

  /// Normal about `mean` with standard deviation `deviation`, cut to [low, high].
  static SizeDistribution normal(double mean, double deviation, double low, double high);

  /// Log-normal, with `mean` and standard deviation `deviation` of the diameter itself, cut to [low, high].
  static SizeDistribution log_normal(double mean, double deviation, double low, double high);

  /// Some diameters, each with its share by number; weights need not sum to 1.
  static SizeDistribution table(std::vector<double> diameters, std::vector<double> weights);

  /// A sieve curve: `passing` is the fraction by mass that is finer than each diameter, rising from 0 to 1; mass is
  /// spread evenly between two sieves.
  static SizeDistribution sieve(std::vector<double> diameters, const std::vector<double>& passing);

  /// The diameter [L] than which a fraction u of [0, 1) of the grains is smaller.
  double quantile(double u) const;

  double smallest() const { return smallest_; }
  double largest() const { return largest_; }

  /// Mean square diameter [L^2]: mean masses go with it.
  double mean_square() const;

 private:
  enum class Kind { uniform, normal, log_normal, table, sieve };

  Kind kind_ = Kind::uniform;
  double smallest_ = 1.0;
  double largest_ = 1.0;
  double centre_ = 0.0;  // of the normal variable
  double spread_ = 1.0;
  double from_ = 0.0;  // its distribution function at the two ends
  double to_ = 1.0;
  std::vector<double> diameters_;
  std::vector<double> below_;  // fraction by number up to each diameter
};

/// Mean and standard deviation of the logarithm of a log-normal variable with this mean and standard deviation.
struct LogMoments {
  double mean;
  double deviation;
};
LogMoments log_moments(double mean, double deviation);

}  // namespace repose
