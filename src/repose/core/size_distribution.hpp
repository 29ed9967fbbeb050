// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace repose {

/// The distribution of grain diameters by number. A diameter is `quantile(u)` of a uniform random number u, so that
/// sizes are reproducible if the random numbers are. Validated by tests/unit/size_distribution_test.cpp.
class SizeDistribution {
 public:
  static SizeDistribution fixed(double diameter);
  static SizeDistribution uniform(double low, double high);

  /// Normal about `mean` with standard deviation `deviation`, cut to [low, high].
  static SizeDistribution normal(double mean, double deviation, double low, double high);

  /// Log-normal, with `mean` and standard deviation `deviation` of the diameter itself, cut to [low, high].
  static SizeDistribution log_normal(double mean, double deviation, double low, double high);

  /// A list of diameters, each with its weight by number; weights need not sum to 1.
  static SizeDistribution table(std::vector<double> diameters, std::vector<double> weights);

  /// A sieve curve: `passing` is the fraction by mass that is finer than each diameter, and rises from 0 to 1. Between
  /// two sieves the mass per diameter is constant.
  static SizeDistribution sieve(std::vector<double> diameters, const std::vector<double>& passing);

  /// The diameter [L] below which the fraction u of the grains by number lies, 0 <= u < 1.
  double quantile(double u) const;

  double smallest() const { return smallest_; }
  double largest() const { return largest_; }

  /// Mean square diameter [L^2] and mean cube [L^3]; the mean masses of a disc and of a sphere are proportional to
  /// them.
  double mean_square() const;
  double mean_cube() const;

 private:
  enum class Kind { uniform, normal, log_normal, table, sieve };

  Kind kind_ = Kind::uniform;
  double smallest_ = 1.0;
  double largest_ = 1.0;
  double centre_ = 0.0;  // mean of the normal variable (of the logarithm, if log-normal)
  double spread_ = 1.0;  // its standard deviation
  double from_ = 0.0;    // its distribution function at the smallest diameter
  double to_ = 1.0;      // and at the largest
  std::vector<double> diameters_;
  std::vector<double> below_;  // fraction by number up to each diameter
};

/// The mean and standard deviation of the logarithm of a log-normal variable.
struct LogMoments {
  double mean;
  double deviation;
};
/// From the mean and standard deviation of the variable itself.
LogMoments log_moments(double mean, double deviation);

}  // namespace repose
