// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/screening_fit.hpp"

#include "repose/core/errors.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>

namespace repose::theory {

namespace {

/// exp(z) - 1 - z without cancellation.
double exp_minus_line(double z) {
  if (std::abs(z) > 0.5) return std::expm1(z) - z;
  double sum = 0.0;
  for (int n = 18; n > 2; --n) sum = (sum + 1.0) * (z / n);
  return 0.5 * z * z * (1.0 + sum);
}

/// Sums over the rows at one lambda_2. f = 1 - exp(-y), y = +-h/lambda_2, is the shape of the law; p = f - y exp(-y) is
/// f plus its derivative with respect to ln(lambda_2). Unlike the derivative, p is not parallel to f for long lambda_2.
/// If pushed up, both are multiplied by -exp(-y) of the highest column, so that nothing overflows.
struct Sums {
  double ff = 0.0;
  double fp = 0.0;
  double pp = 0.0;
  double fm = 0.0;
};

class Problem {
 public:
  Problem(const ScreeningLaw& law, const ApparentMasses& data)
      : law_(law), data_(data), highest_(*std::ranges::max_element(data.height)) {}

  double weight(std::size_t row) const {
    return data_.error.empty() ? 1.0 : 1.0 / (data_.error[row] * data_.error[row]);
  }

  double shape(double height, double lambda) const {
    const double x = height / lambda;
    return law_.sense > 0.0 ? -std::expm1(-x) : -std::expm1(-x) * std::exp((height - highest_) / lambda);
  }
  double change(double height, double lambda) const {
    const double x = height / lambda;
    if (law_.sense < 0.0) return -exp_minus_line(-x) * std::exp((height - highest_) / lambda);
    return x > 1.0 ? -std::expm1(-x) - x * std::exp(-x) : std::exp(-x) * exp_minus_line(x);
  }

  Sums sums(double lambda) const {
    Sums all;
    for (std::size_t row = 0; row < data_.height.size(); ++row) {
      const double f = shape(data_.height[row], lambda);
      const double p = change(data_.height[row], lambda);
      all.ff += weight(row) * f * f;
      all.fp += weight(row) * f * p;
      all.pp += weight(row) * p * p;
      all.fm += weight(row) * f * data_.mass[row];
    }
    return all;
  }

  /// The factor between the fitted mass and the shape.
  double factor(double lambda) const {
    if (law_.parameters == 2) {
      const auto all = sums(lambda);
      return all.fm / all.ff;
    }
    return law_.mass_per_height * lambda * scale(lambda);
  }
  double lambda_1(double lambda) const {
    return law_.parameters == 2 ? factor(lambda) / (law_.mass_per_height * scale(lambda)) : lambda;
  }

  double misfit(double lambda) const {
    const double all = factor(lambda);
    double sum = 0.0;
    for (std::size_t row = 0; row < data_.height.size(); ++row) {
      const double residual = data_.mass[row] - all * shape(data_.height[row], lambda);
      sum += weight(row) * residual * residual;
    }
    return sum;
  }

  /// For a positive factor, it has the sign of minus the derivative of the misfit with respect to lambda_2.
  double improvement(double lambda) const {
    const double all = factor(lambda);
    double sum = 0.0;
    for (std::size_t row = 0; row < data_.height.size(); ++row) {
      const double residual = data_.mass[row] - all * shape(data_.height[row], lambda);
      sum += weight(row) * residual * change(data_.height[row], lambda);
    }
    return sum;
  }

 private:
  double scale(double lambda) const { return law_.sense > 0.0 ? 1.0 : std::exp(highest_ / lambda); }

  const ScreeningLaw& law_;
  const ApparentMasses& data_;
  double highest_;
};

struct Range {
  double low;
  double high;
};

/// The range of ln(lambda_2): below it all shapes are as for lambda_2 = 0, above it they are straight to a millionth.
Range range_of(const ScreeningLaw& law, const std::set<double>& heights) {
  const double shortest = law.sense > 0.0 ? *heights.begin() / 40.0 : *heights.rbegin() / 200.0;
  return {std::log(shortest), std::log(1e6 * *heights.rbegin())};
}

[[noreturn]] void not_determined(const std::string& why) {
  throw InputError("janssen-fit: the data do not determine lambda_2: " + why);
}

/// The ln(lambda_2) of the least misfit: the best point of a fine grid, refined by minimisation. Throws if the best
/// point lies at an end of the range.
double least_misfit(const ScreeningLaw& law, const Problem& problem, const Range& range, double squares) {
  constexpr double step = 0.05;
  constexpr double rounding = 1e-14;
  const auto misfit = [&](double u) { return problem.misfit(std::exp(u)); };
  const auto count = static_cast<int>(std::ceil((range.high - range.low) / step));
  double best = range.low;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= count; ++i) {
    const double u = range.low + step * i;
    const double here = misfit(u);
    if (here < least) {
      least = here;
      best = u;
    }
  }
  const auto found =
      boost::math::tools::brent_find_minima(misfit, best - step, best + step, std::numeric_limits<double>::digits / 2);
  const double tolerance = rounding * squares;
  if (best >= range.high - step || misfit(range.high) <= found.second + tolerance) {
    not_determined(law.parameters == 2 ? "a straight line through 0 (lambda_2 -> infinity) fits as well"
                                       : "no friction (lambda -> infinity) fits as well");
  }
  if (best <= range.low || misfit(range.low) <= found.second + tolerance) {
    if (law.sense < 0.0) not_determined("mass at the greatest height alone (lambda_2 -> 0) fits as well");
    not_determined(law.parameters == 2 ? "the same mass at all heights (lambda_2 -> 0) fits as well"
                                       : "no mass at all (lambda -> 0) fits as well");
  }
  return found.first;
}

/// The root of the derivative next to a minimum, to the last bits; the minimum itself if rounding hides the root.
double refined(const Problem& problem, double u) {
  const auto improvement = [&](double v) { return problem.improvement(std::exp(v)); };
  for (double reach = 1e-8; reach < 0.1; reach *= 4.0) {
    const double below = improvement(u - reach);
    const double above = improvement(u + reach);
    if (below * above > 0.0) continue;
    if (below == 0.0) return u - reach;
    if (above == 0.0) return u + reach;
    std::uintmax_t evaluations = 100;
    const auto root = boost::math::tools::toms748_solve(
        improvement, u - reach, u + reach, below, above,
        boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits), evaluations);
    return 0.5 * (root.first + root.second);
  }
  return u;
}

void set_errors(const ScreeningLaw& law, const Problem& problem, bool errors_given, ScreeningFit& fit) {
  const double factor = problem.factor(fit.lambda_2);
  const auto all = problem.sums(fit.lambda_2);
  const double freedom = static_cast<double>(fit.degrees_of_freedom);
  const double noise =
      errors_given ? 1.0
                   : (freedom > 0.0 ? std::sqrt(fit.chi_square / freedom) : std::numeric_limits<double>::quiet_NaN());
  if (law.parameters == 1) {
    fit.lambda_1_error = fit.lambda_2_error = noise * fit.lambda_2 / (std::abs(factor) * std::sqrt(all.pp));
    fit.correlation = 1.0;
    return;
  }
  // The derivatives with respect to ln(lambda_1) and ln(lambda_2) are f and p - f, both times the factor.
  const double by_1 = std::sqrt(all.ff);
  const double by_2 = std::sqrt(std::max(0.0, all.pp - 2.0 * all.fp + all.ff));
  const double across = std::sqrt(std::max(0.0, all.pp - all.fp * all.fp / all.ff));  // part of p orthogonal to f
  fit.lambda_2_error = noise * fit.lambda_2 / (std::abs(factor) * across);
  fit.lambda_1_error = noise * fit.lambda_1 * by_2 / (std::abs(factor) * by_1 * across);
  fit.correlation = (all.ff - all.fp) / (by_1 * by_2);
}

}  // namespace

ScreeningFit fit_screening(const ScreeningLaw& law, const ApparentMasses& data) {
  std::set<double> heights(data.height.begin(), data.height.end());
  heights.erase(0.0);
  if (static_cast<std::int64_t>(heights.size()) < law.parameters) {
    not_determined(law.parameters == 2 ? "two different heights above 0 are needed" : "no height is above 0");
  }
  const Problem problem{law, data};
  double squares = 0.0;
  for (std::size_t row = 0; row < data.mass.size(); ++row) {
    squares += problem.weight(row) * data.mass[row] * data.mass[row];
  }
  const double start = least_misfit(law, problem, range_of(law, heights), squares);
  ScreeningFit fit;
  fit.lambda_2 = std::exp(refined(problem, start));
  fit.lambda_1 = problem.lambda_1(fit.lambda_2);
  if (fit.lambda_1 <= 0.0) not_determined("the apparent masses are negative");
  fit.chi_square = problem.misfit(fit.lambda_2);
  fit.degrees_of_freedom = static_cast<std::int64_t>(data.height.size()) - law.parameters;
  const double factor = problem.factor(fit.lambda_2);
  double sum = 0.0;
  for (std::size_t row = 0; row < data.height.size(); ++row) {
    fit.fitted.push_back(factor * problem.shape(data.height[row], fit.lambda_2) + 0.0);
    const double residual = data.mass[row] - fit.fitted.back();
    sum += residual * residual;
  }
  fit.rms_residual = std::sqrt(sum / static_cast<double>(data.height.size()));
  set_errors(law, problem, !data.error.empty(), fit);
  return fit;
}

}  // namespace repose::theory
