// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/bootstrap.hpp"

#include "repose/analysis/statistics.hpp"
#include "repose/analysis/student.hpp"
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {
namespace {

/// The mean of values with weights, those from `first` on.
double weighted(const std::vector<double>& values, const std::vector<double>& weights, std::size_t first = 0) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum += weights[first + k] * values[k];
    count += weights[first + k];
  }
  return sum / count;
}

/// n values at equal steps of probability of the normal distribution.
std::vector<double> normal_values(std::size_t n) {
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) {
    values.push_back(normal_quantile((static_cast<double>(k) + 0.5) / static_cast<double>(n)));
  }
  return values;
}

Inference of_the_mean(const std::vector<double>& values) {
  return bootstrap({{values.size()}, [&](const std::vector<double>& weights) { return weighted(values, weights); }},
                   "bootstrap");
}

// A standard deviation from 9999 resamples has a relative error of 1/sqrt(2 x 9999) = 0.7 %: three of these are 2.1 %.
constexpr double three_errors = 0.021;

// For a mean the bootstrap must give Student's t: without bias, with the same error and interval. The ends are
// quantiles at 1 % and less; beyond the median their error is that of the error and of about 100 resamples, 10 % of the
// spacing of quantiles, or 4 % of the distance from the mean.
TEST(Bootstrap, OfAMeanIsStudentsT) {
  for (const std::size_t n : {5U, 10U, 40U}) {
    const auto values = normal_values(n);
    const auto by_t = mean_by_t(values);
    const auto found = of_the_mean(values);
    EXPECT_EQ(found.count, n);
    EXPECT_NEAR(found.value, by_t.value, 1e-14);
    EXPECT_NEAR(found.error, by_t.error, three_errors * by_t.error) << n;
    EXPECT_NEAR(found.bias, 0.0, 3.0 * by_t.error / std::sqrt(9999.0)) << n;
    EXPECT_EQ(found.freedom, by_t.freedom);
    EXPECT_NEAR(found.low, by_t.low, 0.08 * (by_t.value - by_t.low)) << n;
    EXPECT_NEAR(found.high, by_t.high, 0.08 * (by_t.high - by_t.value)) << n;
  }
}

// Two members: three values of a resample are no distribution, but the interval is as wide as Student's all the same.
TEST(Bootstrap, OfTwoMembersIsAsWideAsStudentsT) {
  const auto by_t = mean_by_t({1.0, 3.0});
  const auto found = of_the_mean({1.0, 3.0});
  EXPECT_NEAR(found.error, by_t.error, three_errors * by_t.error);
  EXPECT_NEAR(found.low, by_t.low, 0.05 * (2.0 - by_t.low));
  EXPECT_NEAR(found.high, by_t.high, 0.05 * (by_t.high - 2.0));
}

// Each bound of an interval is excluded just at the level of a test, and p-values are those of Student's t where the
// statistic is a mean. At t = 1, 2 and 3, for ten members, P is 0.17, 0.038 and 0.0075; by counting resamples t is
// known to about 0.05 or 4 %.
TEST(Bootstrap, TestsAgreeWithTheInterval) {
  const auto values = normal_values(10);
  const auto found = of_the_mean(values);
  EXPECT_NEAR(found.p_above(found.low), test_level, 0.03 * test_level);
  EXPECT_NEAR(found.p_below(found.high), test_level, 0.03 * test_level);
  const auto by_t = mean_by_t(values);
  for (const double t : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
    const double bound = by_t.value - t * by_t.error;
    const double slack = 0.05 + 0.04 * std::abs(t);
    EXPECT_GT(found.p_above(bound), student_probability(-t - slack, 9.0)) << t;
    EXPECT_LT(found.p_above(bound), student_probability(-t + slack, 9.0)) << t;
    EXPECT_NEAR(found.p_above(bound) + found.p_below(bound), 1.0, 1e-9);
  }
  // Far outside all resamples p-values still fall, as those of t do: no resample lies at t = -30.
  const double far = found.p_above(by_t.value - 30.0 * by_t.error);
  EXPECT_GT(far, 0.1 * student_probability(-30.0, 9.0));
  EXPECT_LT(far, 10.0 * student_probability(-30.0, 9.0));
}

// The square of a mean m is too large by the variance of the mean, s^2/n, on average. Its bootstrap estimate is s^2/n
// but for the resamples: their mean of x^2 has the standard deviation sqrt(4 m^2 s^2/n + 2 s^4/n^2)/sqrt(9999).
TEST(Bootstrap, BiasOfASquare) {
  auto values = normal_values(20);
  for (auto& value : values) value += 0.5;
  const auto found = bootstrap({{20},
                                [&](const std::vector<double>& weights) {
                                  const double mean = weighted(values, weights);
                                  return mean * mean;
                                }},
                               "bootstrap");
  const double variance = std::pow(mean_of(values).error, 2);
  const double scatter = std::sqrt((4.0 * 0.25 * variance + 2.0 * variance * variance) / 9999.0);
  EXPECT_NEAR(found.bias, variance, 4.0 * scatter);
  EXPECT_LT(4.0 * scatter, 0.25 * variance);
}

// The larger of two means that are equal, from members in opposition (x and -x): max = |mean of x|, which is half
// normal. Bias sqrt(2/pi) times the error of the mean, within three errors of 9999 resamples, and 3 % because the mean
// of 30 draws is not quite normal.
TEST(Bootstrap, BiasOfALargest) {
  const auto values = normal_values(30);
  const auto found = bootstrap({{30},
                                [&](const std::vector<double>& weights) {
                                  const double mean = weighted(values, weights);
                                  return std::max(mean, -mean);
                                }},
                               "bootstrap");
  const double expected = std::sqrt(2.0 / std::numbers::pi) * mean_of(values).error;
  EXPECT_NEAR(found.value, 0.0, 1e-14);
  // The bias grows with the error, which is widened by sqrt(30/29); the estimate is widened by its square.
  EXPECT_NEAR(found.bias, expected, 0.06 * expected);
}

// The interval of the ratio of two means holds the true one, 1.2, for 95 % of 400 samples of eight pairs. A binomial
// count of 400 has a standard deviation of 1.1 %. Percentiles of the resamples alone hold it in 90 % (1793 of 2000
// samples with numpy), which is outside the tolerance.
TEST(Bootstrap, IntervalsHoldTheTrueRatio) {
  constexpr std::size_t n = 8;
  constexpr int samples = 400;
  int held = 0;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> above;
    std::vector<double> below;
    for (std::size_t k = 0; k < n; ++k) {
      const auto index = static_cast<std::uint64_t>(sample) * n + k;
      above.push_back(1.2 + 0.4 * normal_quantile(uniform(3, Purpose::grain_size, index)));
      below.push_back(1.0 + 0.2 * normal_quantile(uniform(4, Purpose::grain_size, index)));
    }
    const auto found = bootstrap(
        {{n}, [&](const std::vector<double>& weights) { return weighted(above, weights) / weighted(below, weights); }},
        "bootstrap");
    if (found.low <= 1.2 && found.high >= 1.2) ++held;
  }
  EXPECT_NEAR(held, 0.95 * samples, 0.04 * samples);
}

// Two samples that share no member: the error is that of Welch, and so are the degrees of freedom for means.
TEST(Bootstrap, OfTwoSamplesIsWelch) {
  const auto first = normal_values(12);
  auto second = normal_values(6);
  for (auto& value : second) value *= 3.0;
  const auto found = bootstrap(
      {{12, 6},
       [&](const std::vector<double>& weights) { return weighted(first, weights) - weighted(second, weights, 12); }},
      "unpaired bootstrap");
  const auto welch = welch_difference(first, second);
  EXPECT_EQ(found.test, "unpaired bootstrap");
  EXPECT_EQ(found.count, 18U);
  EXPECT_NEAR(found.error, welch.error, three_errors * welch.error);
  EXPECT_NEAR(found.freedom, welch.freedom, 1e-9);
}

TEST(Bootstrap, IsTheSameEveryTime) {
  const auto values = normal_values(7);
  const auto one = of_the_mean(values);
  const auto two = of_the_mean(values);
  EXPECT_EQ(one.error, two.error);
  EXPECT_EQ(one.bias, two.bias);
  EXPECT_EQ(one.low, two.low);
}

TEST(Bootstrap, NoneOfOneMemberOrWithoutValues) {
  const auto one = of_the_mean({2.0});
  EXPECT_EQ(one.value, 2.0);
  EXPECT_TRUE(std::isnan(one.error) && std::isnan(one.low));
  EXPECT_TRUE(std::isnan(of_the_mean({}).value));
  // A statistic of four members that needs the first: a resample is without it with probability (3/4)^4 = 0.32.
  const auto often = bootstrap({{4},
                                [](const std::vector<double>& weights) {
                                  return weights[0] > 0.0 ? 1.0 + weights[1] : std::numeric_limits<double>::quiet_NaN();
                                }},
                               "bootstrap");
  EXPECT_EQ(often.value, 2.0);
  EXPECT_TRUE(std::isnan(often.error));
}

TEST(Bootstrap, WithoutScatter) {
  const auto found = of_the_mean({0.1, 0.1, 0.1, 0.1});
  EXPECT_NEAR(found.error, 0.0, 1e-16);
  const auto exact = of_the_mean({2.0, 2.0, 2.0, 2.0});
  EXPECT_EQ(exact.error, 0.0);
  EXPECT_EQ(exact.low, 2.0);
  EXPECT_EQ(exact.p_above(1.0), 0.0);
  EXPECT_EQ(exact.p_above(2.0), 1.0);
}

}  // namespace
}  // namespace repose
