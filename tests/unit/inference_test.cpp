// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/inference.hpp"

#include "repose/analysis/holm.hpp"
#include "repose/analysis/student.hpp"
#include "support/sleep_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace repose {
namespace {

// 1 degree: the Cauchy distribution, tan(pi (p - 1/2)) in closed form. 2 degrees: t = x sqrt(2/(1 - x^2)), x = 2p - 1.
// 9 and 9.5: computed with mpmath to 40 digits. Without end: the normal distribution. Tolerance: rounding of series.
TEST(Student, Quantiles) {
  EXPECT_NEAR(student_quantile(0.975, 1.0), std::tan(std::acos(-1.0) * 0.475), 1e-11);
  EXPECT_NEAR(student_quantile(0.975, 2.0), 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95)), 1e-12);
  EXPECT_NEAR(student_quantile(0.975, 9.0), 2.2621571627982055, 1e-12);
  EXPECT_NEAR(student_quantile(0.975, 9.5), 2.2441374614922965, 1e-12);
  EXPECT_NEAR(student_quantile(0.975, 1e12), normal_quantile(0.975), 1e-10);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-13);
}

TEST(Student, ProbabilitiesInvertQuantiles) {
  EXPECT_NEAR(student_probability(-3.0, 4.0), 0.019970984035859413, 1e-14);
  for (const double p : {1e-6, 0.025, 0.5, 0.9}) {
    EXPECT_NEAR(student_probability(student_quantile(p, 3.5), 3.5), p, 1e-12 * p);
    EXPECT_NEAR(normal_probability(normal_quantile(p)), p, 1e-12 * p);
  }
  EXPECT_EQ(student_probability(std::numeric_limits<double>::infinity(), 3.0), 1.0);
  EXPECT_EQ(student_probability(-std::numeric_limits<double>::infinity(), 3.0), 0.0);
}

TEST(Student, TenDigits) {
  EXPECT_EQ(ten_digits(0.123456789012345), 0.1234567890);
  EXPECT_EQ(ten_digits(-1.0 / 3.0), -0.3333333333);
  EXPECT_EQ(ten_digits(0.0), 0.0);
  EXPECT_TRUE(std::isnan(ten_digits(Inference::none)));
}

// 1, 2, 6 and a NaN: mean 3, error sqrt(7/3), t of two degrees by its closed form.
TEST(Inference, IntervalOfAMean) {
  const auto found = mean_by_t({1.0, Inference::none, 2.0, 6.0});
  const double error = std::sqrt(7.0 / 3.0);
  const double t = 0.95 * std::sqrt(2.0 / (1.0 - 0.95 * 0.95));
  EXPECT_EQ(found.test, "t");
  EXPECT_EQ(found.count, 3U);
  EXPECT_EQ(found.freedom, 2.0);
  EXPECT_DOUBLE_EQ(found.value, 3.0);
  EXPECT_NEAR(found.error, error, 1e-15);
  EXPECT_NEAR(found.low, 3.0 - t * error, 1e-8);  // kept to ten digits
  EXPECT_NEAR(found.high, 3.0 + t * error, 1e-8);
  // P(T > x) of two degrees is (1 - x/sqrt(2 + x^2))/2.
  const double x = (3.0 - 0.5) / error;
  EXPECT_NEAR(found.p_above(0.5), 0.5 * (1.0 - x / std::sqrt(2.0 + x * x)), 1e-10);
  EXPECT_NEAR(found.p_above(0.5) + found.p_below(0.5), 1.0, 1e-9);
  EXPECT_NEAR(found.p_above(found.low), test_level, 1e-9);
  EXPECT_NEAR(found.p_below(found.high), test_level, 1e-9);
  EXPECT_TRUE(std::isnan(found.bias));
}

TEST(Inference, PairedDifference) {
  const auto found = paired_difference(first_drug, second_drug);
  EXPECT_EQ(found.test, "paired t");
  EXPECT_EQ(found.count, 10U);
  EXPECT_NEAR(found.value, -1.58, 1e-14);
  EXPECT_NEAR(found.error, 0.3889587238883952, 1e-14);
  EXPECT_NEAR(found.low, -2.4598857632769828, 1e-9);
  EXPECT_NEAR(found.high, -0.7001142367230172, 1e-9);
  EXPECT_NEAR(found.p_below(0.0), 0.00141644509869213637, 1e-11);
}

TEST(Inference, WelchDifference) {
  const auto found = welch_difference(first_drug, second_drug);
  EXPECT_EQ(found.test, "Welch t");
  EXPECT_EQ(found.count, 20U);
  EXPECT_NEAR(found.value, -1.58, 1e-14);
  EXPECT_NEAR(found.error, 0.849091017238762, 1e-14);
  EXPECT_NEAR(found.freedom, 17.776473516178495, 1e-12);
  EXPECT_NEAR(found.low, -3.365483230711636, 1e-9);
  EXPECT_NEAR(found.high, 0.20548323071163632, 1e-9);
  EXPECT_NEAR(found.p_below(0.0), 0.0396970700936790692, 1e-10);
}

// A pair with a NaN does not count, on whichever side the NaN is.
TEST(Inference, PairsNeedBothValues) {
  const auto found = paired_difference({1.0, Inference::none, 3.0, 5.0}, {0.0, 1.0, Inference::none, 2.0});
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(found.value, 2.0);
  EXPECT_EQ(found.error, 1.0);
}

TEST(Inference, OneMemberTellsNoError) {
  for (const auto& found : {mean_by_t({2.0}), paired_difference({3.0}, {1.0}), welch_difference({3.0, 4.0}, {1.5})}) {
    EXPECT_EQ(found.value, 2.0);
    EXPECT_TRUE(std::isnan(found.error) && std::isnan(found.low) && std::isnan(found.high));
    EXPECT_FALSE(found.p_above);
  }
  EXPECT_TRUE(std::isnan(mean_by_t({}).value));
}

// Equal members: the value is off every bound but itself.
TEST(Inference, MembersWithoutScatter) {
  const auto found = mean_by_t({2.0, 2.0, 2.0});
  EXPECT_EQ(found.error, 0.0);
  EXPECT_EQ(found.p_above(1.0), 0.0);
  EXPECT_EQ(found.p_above(2.0), 1.0);
  EXPECT_EQ(found.p_below(2.0), 1.0);
  EXPECT_EQ(found.p_above(3.0), 1.0);
}

// By hand: 4 x 0.01, then 3 x 0.013, 2 x 0.03, 1 x 0.04, none below the one before.
TEST(Holm, ByHand) {
  const auto adjusted = holm_adjusted({0.03, 0.01, Inference::none, 0.04, 0.013});
  ASSERT_EQ(adjusted.size(), 5U);
  EXPECT_NEAR(adjusted[0], 0.06, 1e-15);
  EXPECT_NEAR(adjusted[1], 0.04, 1e-15);
  EXPECT_TRUE(std::isnan(adjusted[2]));
  EXPECT_NEAR(adjusted[3], 0.06, 1e-15);
  EXPECT_NEAR(adjusted[4], 0.04, 1e-15);  // 0.039 is raised to the step before
}

TEST(Holm, ProbabilitiesStayProbabilities) {
  EXPECT_EQ(holm_adjusted({0.9, 0.8}), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(holm_adjusted({0.2}), (std::vector<double>{0.2}));
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace repose
