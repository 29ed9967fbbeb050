// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/screening_fit.hpp"

#include "repose/core/errors.hpp"
#include "repose/theory/janssen_discrete.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

namespace repose::theory {
namespace {

constexpr double mass_per_height = 0.37;

double law(double sense, double lambda_1, double lambda_2, double height) {
  return sense * mass_per_height * lambda_1 * (1.0 - std::exp(-sense * height / lambda_2));
}

ApparentMasses exact(double sense, double lambda_1, double lambda_2, std::size_t count, double step) {
  ApparentMasses data;
  for (std::size_t i = 1; i <= count; ++i) {
    data.height.push_back(step * static_cast<double>(i));
    data.mass.push_back(law(sense, lambda_1, lambda_2, data.height.back()));
  }
  return data;
}

std::string complaint(const ScreeningLaw& law, const ApparentMasses& data) {
  try {
    fit_screening(law, data);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ScreeningFit, FindsTheLengthsOfExactData) {
  for (const double sense : {1.0, -1.0}) {
    for (const double lambda_2 : {0.3, 2.0, 40.0}) {
      const double lambda_1 = 1.3 * lambda_2;
      const auto two = fit_screening({mass_per_height, sense, 2}, exact(sense, lambda_1, lambda_2, 12, 0.5));
      EXPECT_NEAR(two.lambda_1, lambda_1, 1e-10 * lambda_1) << sense << ' ' << lambda_2;
      EXPECT_NEAR(two.lambda_2, lambda_2, 1e-10 * lambda_2) << sense << ' ' << lambda_2;
      EXPECT_EQ(two.degrees_of_freedom, 10);
      const auto one = fit_screening({mass_per_height, sense, 1}, exact(sense, lambda_2, lambda_2, 12, 0.5));
      EXPECT_NEAR(one.lambda_2, lambda_2, 1e-12 * lambda_2) << sense << ' ' << lambda_2;
      EXPECT_EQ(one.lambda_1, one.lambda_2);
      EXPECT_LT(one.rms_residual, 1e-13 * one.fitted.back());
    }
  }
}

// With the cells of the discrete model as heights, three grains each, the fit finds the lengths of the model.
TEST(ScreeningFit, FindsTheLengthsOfTheDiscreteModel) {
  for (const auto& [direction, sense, ratio] :
       {std::tuple{"rest", 1.0, 0.91161}, std::tuple{"pushed-up", -1.0, 1.11572}}) {
    const JanssenDiscrete stack{.k_mu = 0.1, .layers = 25, .direction = direction};
    const auto table = evaluate(stack);
    const auto fit = fit_screening({3.0, sense, 2}, {table.column("layer").values, table.column("force").values, {}});
    EXPECT_NEAR(fit.lambda_1 / fit.lambda_2, ratio, 5e-6);
    EXPECT_NEAR(fit.lambda_1, table.number("lambda_1"), 1e-11 * fit.lambda_1);
    EXPECT_NEAR(fit.lambda_2, table.number("lambda_2"), 1e-11 * fit.lambda_2);
  }
}

struct Noisy {
  ApparentMasses data;
  std::mt19937_64 random;
  std::normal_distribution<double> normal;

  explicit Noisy(std::uint64_t seed) : random(seed) {}
  /// Errors of 1 to 3 per cent, different from row to row.
  void draw(double sense, double lambda_1, double lambda_2, bool with_errors) {
    data = exact(sense, lambda_1, lambda_2, 15, 0.4);
    for (std::size_t i = 0; i < data.mass.size(); ++i) {
      const double error = (with_errors ? 0.01 * (1.0 + static_cast<double>(i % 3)) * data.mass[i] : 0.01);
      data.mass[i] += error * normal(random);
      if (with_errors) data.error.push_back(error);
    }
  }
};

double chi_square(double sense, double lambda_1, double lambda_2, const ApparentMasses& data) {
  double sum = 0.0;
  for (std::size_t i = 0; i < data.mass.size(); ++i) {
    const double residual = data.mass[i] - law(sense, lambda_1, lambda_2, data.height[i]);
    sum += std::pow(residual / (data.error.empty() ? 1.0 : data.error[i]), 2);
  }
  return sum;
}

// With noisy data, the independently computed sum of squares has its minimum at the fit, and the errors are those of
// the inverse matrix of numerical derivatives of the law.
TEST(ScreeningFit, IsTheLeastSumOfSquares) {
  for (const double sense : {1.0, -1.0}) {
    for (const bool with_errors : {true, false}) {
      Noisy noisy{7};
      noisy.draw(sense, 3.0, 2.5, with_errors);
      const auto fit = fit_screening({mass_per_height, sense, 2}, noisy.data);
      const auto around = [&](double a, double b) {
        return chi_square(sense, fit.lambda_1 * (1.0 + a), fit.lambda_2 * (1.0 + b), noisy.data);
      };
      const double least = around(0.0, 0.0);
      EXPECT_NEAR(fit.chi_square, least, 1e-12 * least);
      constexpr double step = 1e-4;
      const double curve_1 = (around(step, 0.0) - 2.0 * least + around(-step, 0.0)) / (step * step);
      const double curve_2 = (around(0.0, step) - 2.0 * least + around(0.0, -step)) / (step * step);
      // Slopes in units of the curvature: the distance to the minimum relative to the length.
      EXPECT_NEAR((around(step, 0.0) - around(-step, 0.0)) / (2.0 * step) / curve_1, 0.0, 1e-6);
      EXPECT_NEAR((around(0.0, step) - around(0.0, -step)) / (2.0 * step) / curve_2, 0.0, 1e-6);

      double matrix[3] = {0.0, 0.0, 0.0};
      for (std::size_t i = 0; i < noisy.data.mass.size(); ++i) {
        const auto value = [&](double a, double b) {
          return law(sense, fit.lambda_1 + a, fit.lambda_2 + b, noisy.data.height[i]) /
                 (with_errors ? noisy.data.error[i] : 1.0);
        };
        const double by_1 = (value(step, 0.0) - value(-step, 0.0)) / (2.0 * step);
        const double by_2 = (value(0.0, step) - value(0.0, -step)) / (2.0 * step);
        matrix[0] += by_1 * by_1;
        matrix[1] += by_1 * by_2;
        matrix[2] += by_2 * by_2;
      }
      const double determinant = matrix[0] * matrix[2] - matrix[1] * matrix[1];
      const double variance = with_errors ? 1.0 : least / 13.0;
      EXPECT_NEAR(fit.lambda_1_error, std::sqrt(variance * matrix[2] / determinant), 1e-6 * fit.lambda_1_error);
      EXPECT_NEAR(fit.lambda_2_error, std::sqrt(variance * matrix[0] / determinant), 1e-6 * fit.lambda_2_error);
      EXPECT_NEAR(fit.correlation, -matrix[1] / std::sqrt(matrix[0] * matrix[2]), 1e-6);
    }
  }
}

// 2000 draws of noise. The scatter of the estimates agrees with their errors (a standard deviation from 2000 draws is
// accurate to 1/sqrt(4000) = 1.6 per cent; three times that is allowed, and 1 per cent for the curvature of the law).
// The estimates are right on average. The true value lies within one error as often as a normal deviate: 68.3 +- 1.04
// per cent (with 13 degrees of freedom that scale the errors: Student's t, 66.4).
TEST(ScreeningFit, ErrorsAreTheScatterOfTheEstimates) {
  constexpr int draws = 2000;
  for (const double sense : {1.0, -1.0}) {
    for (const bool with_errors : {true, false}) {
      for (const std::int64_t parameters : {1, 2}) {
        const double lambda_1 = parameters == 1 ? 2.5 : 3.0;
        const double lambda_2 = 2.5;
        Noisy noisy{static_cast<std::uint64_t>(parameters)};
        std::array<double, 2> sum{};
        std::array<double, 2> squares{};
        std::array<double, 2> variances{};
        std::array<int, 2> within{};
        double chi = 0.0;
        for (int i = 0; i < draws; ++i) {
          noisy.draw(sense, lambda_1, lambda_2, with_errors);
          const auto fit = fit_screening({mass_per_height, sense, parameters}, noisy.data);
          const std::array off = {fit.lambda_1 - lambda_1, fit.lambda_2 - lambda_2};
          const std::array error = {fit.lambda_1_error, fit.lambda_2_error};
          chi += fit.chi_square / static_cast<double>(fit.degrees_of_freedom) / draws;
          for (std::size_t k = 0; k < 2; ++k) {
            sum[k] += off[k] / draws;
            squares[k] += off[k] * off[k] / draws;
            variances[k] += error[k] * error[k] / draws;
            within[k] += std::abs(off[k]) < error[k] ? 1 : 0;
          }
        }
        for (std::size_t k = 0; k < 2; ++k) {
          const double scatter = std::sqrt(squares[k] - sum[k] * sum[k]);
          EXPECT_NEAR(scatter / std::sqrt(variances[k]), 1.0, 0.06) << sense << with_errors << parameters << k;
          EXPECT_NEAR(sum[k], 0.0, 0.15 * scatter) << sense << with_errors << parameters << k;
          EXPECT_NEAR(within[k], (with_errors ? 0.683 : 0.665) * draws, 3.5 * 0.0104 * draws)
              << sense << with_errors << parameters << k;
        }
        if (with_errors) {
          EXPECT_NEAR(chi, 1.0, 3.5 * std::sqrt(2.0 / 13.0 / draws)) << sense << parameters;
        }
      }
    }
  }
}

TEST(ScreeningFit, RefusesDataThatDoNotDetermineTheLengths) {
  const ScreeningLaw rest{mass_per_height, 1.0, 2};
  const ScreeningLaw up{mass_per_height, -1.0, 2};
  const std::vector<double> heights = {1.0, 2.0, 3.0, 4.0};
  EXPECT_NE(complaint(rest, {heights, {1.0, 2.0, 3.0, 4.0}, {}}).find("straight line"), std::string::npos);
  EXPECT_NE(complaint(rest, {heights, {1.0, 2.1, 3.3, 4.6}, {}}).find("straight line"), std::string::npos);
  EXPECT_NE(complaint(up, {heights, {1.0, 1.9, 2.7, 3.4}, {}}).find("straight line"), std::string::npos);
  EXPECT_NE(complaint(rest, {heights, {2.0, 2.0, 2.0, 2.0}, {}}).find("same mass"), std::string::npos);
  EXPECT_NE(complaint(up, {heights, {0.0, 0.0, 0.0, 2.0}, {}}).find("greatest height alone"), std::string::npos);
  EXPECT_NE(complaint(rest, {{2.0, 2.0, 0.0}, {1.0, 1.0, 0.0}, {}}).find("two different heights"), std::string::npos);
  EXPECT_NE(complaint({mass_per_height, 1.0, 1}, {{0.0}, {0.0}, {}}).find("no height"), std::string::npos);
  EXPECT_NE(complaint({mass_per_height, 1.0, 1}, {heights, {0.5, 1.0, 1.5, 2.0}, {}}).find("no friction"),
            std::string::npos);
  EXPECT_NE(complaint({mass_per_height, 1.0, 1}, {heights, {-1.0, -1.0, -1.0, -1.0}, {}}).find("no mass"),
            std::string::npos);
  EXPECT_NE(complaint(rest, {heights, {-1.0, -1.5, -1.7, -1.8}, {}}).find("negative"), std::string::npos);
}

// With as many rows as parameters the law passes through the data, and errors follow only from errors of the data.
TEST(ScreeningFit, WithoutFreedomErrorsNeedThoseOfTheData) {
  auto data = exact(1.0, 2.0, 1.5, 2, 1.0);
  const auto fit = fit_screening({mass_per_height, 1.0, 2}, data);
  EXPECT_NEAR(fit.lambda_2, 1.5, 1e-11);
  EXPECT_EQ(fit.degrees_of_freedom, 0);
  EXPECT_TRUE(std::isnan(fit.lambda_2_error));
  data.error = {0.01, 0.01};
  EXPECT_GT(fit_screening({mass_per_height, 1.0, 2}, data).lambda_2_error, 0.0);
}

}  // namespace
}  // namespace repose::theory
