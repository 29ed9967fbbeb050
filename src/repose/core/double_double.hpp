// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// An unevaluated sum of two doubles, |low| at most half a unit in the last place of high: about 106 bits. All
/// operations are plain ones of double, without fused multiply-add, so that every processor gives the same bits.
/// Source: Dekker (1971); Knuth, The Art of Computer Programming 2, 4.2.2. Relative errors are a few 2^-104, for
/// numbers from 1e-200 to 1e200. Validated by tests/unit/reproducible_math_test.cpp.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT(google-explicit-constructor)
  constexpr DoubleDouble(double upper, double lower) : high(upper), low(lower) {}
};

/// a + b, exact; |a| >= |b| or a = 0.
constexpr DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b, exact.
constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a in two halves of 26 bits each, whose products are exact. |a| < 2^996.
constexpr DoubleDouble halves(double a) {
  const double shifted = 0x1.0000002p27 * a;
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// a b, exact unless it underflows.
constexpr DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  const auto x = halves(a);
  const auto y = halves(b);
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const auto high = exact_sum(a.high, b.high);
  const auto low = exact_sum(a.low, b.low);
  const auto sum = ordered_sum(high.high, high.low + low.high);
  return ordered_sum(sum.high, sum.low + low.low);
}
constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const auto product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double quotient = a.high / b.high;
  const auto left = a - b * quotient;
  return ordered_sum(quotient, left.high / b.high);
}

}  // namespace repose
