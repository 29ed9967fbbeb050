// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/reproducible_math.hpp"

#include "repose/core/double_double_functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose::reproducible {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Whether the reduction of an angle has bits enough.
bool reducible(double x) { return std::fabs(x) < 1e6; }

}  // namespace

double log(double x) {
  if (std::isnan(x) || x < 0.0) return not_a_number;
  if (x == 0.0) return -infinity;
  if (x == infinity) return x;
  if (x >= std::numeric_limits<double>::min()) return logarithm(x).high;
  constexpr int shift = 54;
  return (logarithm(std::ldexp(x, shift)) - constants::ln2_rest * shift - shift * constants::ln2_first).high;
}

double log1p(double x) {
  if (std::isnan(x) || x < -1.0) return not_a_number;
  if (x == -1.0) return -infinity;
  if (x == infinity || std::fabs(x) < 0x1p-54) return x;
  return logarithm(exact_sum(1.0, x)).high;
}

double sin(double x) {
  if (std::fabs(x) < 0x1p-27) return x;
  return reducible(x) ? sine_and_cosine(x).first.high : not_a_number;
}

double cos(double x) { return reducible(x) ? sine_and_cosine(x).second.high : not_a_number; }

double tan(double x) {
  if (std::fabs(x) < 0x1p-27) return x;
  if (!reducible(x)) return not_a_number;
  const auto [sine, cosine] = sine_and_cosine(x);
  return (sine / cosine).high;
}

double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return infinity;
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double largest = std::max(std::fabs(x), std::fabs(y));
  if (largest == 0.0) return 0.0;
  const int exponent = std::ilogb(largest);
  x = std::ldexp(x, -exponent);
  y = std::ldexp(y, -exponent);
  const auto square = exact_product(x, x) + exact_product(y, y);
  const double root = std::sqrt(square.high);
  return std::ldexp(root + 0.5 * (square - exact_product(root, root)).high / root, exponent);
}

}  // namespace repose::reproducible
