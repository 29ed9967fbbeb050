// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/tail_fit.hpp"

#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace repose {
namespace {

/// Sizes by their inverse distribution, with `draw` uniform in (0, 1].
std::vector<double> sizes(std::size_t count, std::uint64_t seed, const std::function<double(double draw)>& inverse) {
  std::vector<double> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(inverse(1.0 - uniform(seed, Purpose::resample, k)));
  return all;
}

std::function<double(double)> power_law(double exponent) {
  return [=](double draw) { return std::pow(draw, -1.0 / (exponent - 1.0)); };
}

class PowerLaw : public ::testing::TestWithParam<double> {};

// A sample is farther off than two standard errors with a probability of 4.6 %, five or more of 20 with 0.2 %.
TEST_P(PowerLaw, IsRecoveredFromItsSamples) {
  const double exponent = GetParam();
  int far_off = 0;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto found = fit_tail(sizes(10000, seed, power_law(exponent)), 0);
    EXPECT_EQ(found.events, 10000);
    EXPECT_NEAR(found.error, (found.exponent - 1.0) / std::sqrt(static_cast<double>(found.tail)), 1e-9);
    EXPECT_GE(found.x_min, 1.0);
    EXPECT_GT(found.exponential.log_ratio, 0.0);
    EXPECT_LT(found.exponential.p_value, 0.05);
    sum += (found.exponent - exponent) / found.error;
    if (std::fabs(found.exponent - exponent) > 2.0 * found.error) ++far_off;
  }
  EXPECT_LT(far_off, 5);
  EXPECT_LT(std::fabs(sum / 20.0), 3.0 / std::sqrt(20.0));  // no bias beyond three standard errors
}
INSTANTIATE_TEST_SUITE_P(Exponents, PowerLaw, ::testing::Values(1.5, 1.8, 2.5));

// The p-value of a sample of the law is anything from 0 to 1; of one that is no power law it is below 0.1.
TEST(TailFit, SyntheticSamplesRefuteWhatIsNoPowerLaw) {
  EXPECT_GT(fit_tail(sizes(1000, 1, power_law(1.8)), 40).p_value, 0.1);
  // Two laws with a break: half of the sizes begin at 3.
  auto broken = sizes(1500, 1, power_law(4.0));
  for (const double x : sizes(1500, 2, power_law(1.5))) broken.push_back(3.0 * x);
  const auto found = fit_tail(broken, 40);
  EXPECT_GE(found.x_min, 2.5);  // the fit begins where one law is left
}

TEST(TailFit, APowerLawIsClaimedWithEnoughEventsAlone) {
  const auto many = fit_tail(sizes(40000, 2, power_law(1.8)), 0);
  EXPECT_GE(many.tail, least_events_of_power_law);
  EXPECT_EQ(many.verdict, "power law");
  const auto few = fit_tail(sizes(500, 2, power_law(1.8)), 0);
  EXPECT_NE(few.verdict.find("events in the tail, 10000 needed"), std::string::npos) << few.verdict;
  // Cut above 20: the logarithm falls faster than a power law, and has no two decades.
  const auto cut = fit_tail(
      sizes(20000, 2,
            [](double draw) { return std::pow(1.0 - (1.0 - draw) * (1.0 - std::pow(20.0, -0.8)), -1.0 / 0.8); }),
      0);
  EXPECT_NE(cut.verdict, "power law");
  EXPECT_LT(cut.decades, 1.31);
}

TEST(TailFit, ExponentialAndLogNormalSizesAreRefused) {
  for (const double begin : {0.0, 1.0}) {
    const auto found = fit_tail(sizes(10000, 3, [&](double draw) { return begin - std::log(draw); }), 0);
    EXPECT_EQ(found.verdict.find("no power law"), 0U) << found.verdict;
  }
  std::vector<double> log_normal;
  for (std::size_t k = 0; k < 10000; ++k) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(4, Purpose::resample, k)));
    log_normal.push_back(std::exp(0.5 * radius * std::cos(6.283185307179586 * uniform(4, Purpose::resample, k, 1))));
  }
  const auto found = fit_tail(log_normal, 0);
  EXPECT_EQ(found.verdict.find("no power law"), 0U) << found.verdict;
}

TEST(TailFit, WithoutEnoughSizesThereIsNoFit) {
  EXPECT_EQ(fit_tail({}).verdict, "undecided: 0 events, a fit needs 50");
  EXPECT_EQ(fit_tail({1.0, -2.0, 0.0}).events, 1);
  EXPECT_EQ(fit_tail(std::vector<double>(100, 3.0)).verdict, "no power law: all events have one size");
}

}  // namespace
}  // namespace repose
