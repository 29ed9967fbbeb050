// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/size_distribution.hpp"

#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace repose {
namespace {

constexpr std::size_t sample_size = 20000;

std::vector<double> sample(const SizeDistribution& sizes) {
  std::vector<double> drawn;
  for (std::size_t k = 0; k < sample_size; ++k) drawn.push_back(sizes.quantile(uniform(1, Purpose::grain_size, k)));
  return drawn;
}

double mean(const std::vector<double>& values, double power = 1.0) {
  double sum = 0.0;
  for (const double value : values) sum += std::pow(value, power);
  return sum / static_cast<double>(values.size());
}

/// The largest distance between the distribution function of the drawn sizes and the exact one, times sqrt(n).
double kolmogorov(std::vector<double> drawn, const std::function<double(double)>& fraction_below) {
  std::sort(drawn.begin(), drawn.end());
  const auto n = static_cast<double>(drawn.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const double expected = fraction_below(drawn[k]);
    largest = std::max({largest, expected - static_cast<double>(k) / n, static_cast<double>(k + 1) / n - expected});
  }
  return std::sqrt(n) * largest;
}

// Kolmogorov and Smirnov: a correct sample of 20000 (seed 1) exceeds 1.95 once in 1000 times.
constexpr double rare = 1.95;

double standard_normal(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(SizeDistribution, Uniform) {
  const auto drawn = sample(SizeDistribution::uniform(0.5, 1.5));
  EXPECT_LT(kolmogorov(drawn, [](double d) { return d - 0.5; }), rare);
  // The test detects a shift of 2 % of the width: 20000 sizes resolve 0.014.
  EXPECT_GT(kolmogorov(drawn, [](double d) { return d - 0.52; }), rare);
}

// Cut at -1 and +2 deviations, where the cuts matter; the ends are exact to the bit.
TEST(SizeDistribution, NormalIsCut) {
  const auto sizes = SizeDistribution::normal(1.0, 0.2, 0.8, 1.4);
  const auto drawn = sample(sizes);
  const double from = standard_normal(-1.0);
  const double to = standard_normal(2.0);
  const auto fraction = [&](double d) { return (standard_normal((d - 1.0) / 0.2) - from) / (to - from); };
  EXPECT_LT(kolmogorov(drawn, fraction), rare);
  EXPECT_GT(kolmogorov(drawn, [](double d) { return standard_normal((d - 1.0) / 0.2); }), rare);
  EXPECT_GE(*std::min_element(drawn.begin(), drawn.end()), 0.8);
  EXPECT_LE(*std::max_element(drawn.begin(), drawn.end()), 1.4);
  EXPECT_NEAR(sizes.quantile(0.0), 0.8, 1e-14);
  EXPECT_NEAR(sizes.quantile(1.0 - 0x1p-53), 1.4, 1e-14);
}

// Mean and deviation are those of the diameter, within 4 standard errors of 20000 sizes. The cuts, at 6 deviations of
// the logarithm, do not matter.
TEST(SizeDistribution, LogNormalHasTheMomentsOfTheDiameter) {
  const auto [centre, spread] = log_moments(1.0, 0.3);
  const auto drawn =
      sample(SizeDistribution::log_normal(1.0, 0.3, std::exp(centre - 6.0 * spread), std::exp(centre + 6.0 * spread)));
  const double n = static_cast<double>(sample_size);
  const double found = mean(drawn);
  EXPECT_NEAR(found, 1.0, 4.0 * 0.3 / std::sqrt(n));
  // Kurtosis of a log-normal with exp(s^2) = 1.09: 4.65; the variance of a sample variance is (kurtosis - 1) var^2 / n.
  EXPECT_NEAR(mean(drawn, 2.0) - found * found, 0.09, 4.0 * 0.09 * std::sqrt(3.65 / n));
  EXPECT_LT(kolmogorov(drawn, [&](double d) { return standard_normal((std::log(d) - centre) / spread); }), rare);
}

// Chi-square of three counts: 2 degrees of freedom, above 13.8 once in 1000 times.
TEST(SizeDistribution, TableByNumber) {
  const auto drawn = sample(SizeDistribution::table({0.5, 2.0, 1.0}, {1.0, 3.0, 4.0}));
  double chi2 = 0.0;
  for (const auto& [diameter, fraction] : {std::pair{0.5, 0.125}, {2.0, 0.375}, {1.0, 0.5}}) {
    const auto count = static_cast<double>(std::count(drawn.begin(), drawn.end(), diameter));
    const double expected = fraction * static_cast<double>(sample_size);
    chi2 += std::pow(count - expected, 2) / expected;
  }
  EXPECT_LT(chi2, 13.8);
  EXPECT_GT(chi2, 1e-3);
}

// For a sieve curve, the mass of the drawn grains finer than d is that of the curve. The mass is proportional to the
// square of the diameter; 4 standard errors of 20000 grains are 0.02. If the curve were taken by number, finer(1) would
// be 0.10.
TEST(SizeDistribution, SieveCurveByMass) {
  const auto sizes = SizeDistribution::sieve({0.5, 1.0, 2.0}, {0.0, 0.3, 1.0});
  const auto drawn = sample(sizes);
  const auto finer = [&](double d) {
    double mass = 0.0;
    for (const double one : drawn) mass += one < d ? one * one : 0.0;
    return mass / (mean(drawn, 2.0) * static_cast<double>(sample_size));
  };
  EXPECT_NEAR(finer(0.75), 0.15, 0.02);
  EXPECT_NEAR(finer(1.0), 0.3, 0.02);
  EXPECT_NEAR(finer(1.5), 0.65, 0.02);
  EXPECT_GE(*std::min_element(drawn.begin(), drawn.end()), 0.5);
  EXPECT_LE(*std::max_element(drawn.begin(), drawn.end()), 2.0);
}

// Closed forms. The sum over 4096 quantiles is accurate to 1e-6 if the quantile function is smooth.
TEST(SizeDistribution, MeanSquare) {
  EXPECT_NEAR(SizeDistribution::fixed(0.7).mean_square(), 0.49, 1e-12);
  EXPECT_NEAR(SizeDistribution::uniform(0.5, 1.5).mean_square(), (1.5 * 1.5 + 1.5 * 0.5 + 0.25) / 3.0, 1e-6);
  EXPECT_NEAR(SizeDistribution::table({1.0, 2.0}, {1.0, 1.0}).mean_square(), 2.5, 1e-3);
}

}  // namespace
}  // namespace repose
