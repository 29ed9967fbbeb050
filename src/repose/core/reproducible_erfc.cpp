// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/double_double_functions.hpp"
#include "repose/core/reproducible_math.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose::reproducible {

namespace {

constexpr DoubleDouble two_over_root_pi{0x1.20dd750429b6dp+0, 0x1.1ae3a914fed80p-56};

/// 2^n/(2n + 1)!!, where (2n + 1)!! = 1 3 5 ... (2n + 1)
constexpr auto series_of_erf = [] {
  std::array<DoubleDouble, 100> table{1.0};
  for (std::size_t n = 1; n < table.size(); ++n) table[n] = table[n - 1] * 2.0 / static_cast<double>(2 * n + 1);
  return table;
}();

/// 2/sqrt(pi) e^(-x^2), the slope of erf.
DoubleDouble slope(double x) {
  const auto power = exponential(-exact_product(x, x));
  const auto value = two_over_root_pi * power.value;
  return {std::ldexp(value.high, power.exponent), std::ldexp(value.low, power.exponent)};
}

/// erf(x)/slope(x), x from 0 to 4: a series of positive terms. Source: Abramowitz and Stegun, 7.1.6.
DoubleDouble erf_over_slope(double x) {
  const auto square = exact_product(x, x);
  DoubleDouble sum;
  for (auto n = static_cast<std::size_t>(16.0 + 20.0 * x); n-- > 0;) sum = sum * square + series_of_erf[n];
  return sum * x;
}

/// erfc(x)/slope(x), x from 4: a continued fraction. Source: Abramowitz and Stegun, 7.1.14.
DoubleDouble erfc_over_slope(double x) {
  DoubleDouble fraction{x};
  for (int n = 50; n > 0; --n) fraction = DoubleDouble(0.5 * n) / fraction + x;
  return DoubleDouble(0.5) / fraction;
}

/// erfc(x), x from 0 to 28.
DoubleDouble tail(double x) {
  if (x < 4.0) return DoubleDouble(1.0) - slope(x) * erf_over_slope(x);
  return slope(x) * erfc_over_slope(x);
}

/// erfc at nodes from 0 to 6, from which its inverse is continued.
struct Nodes {
  static constexpr int per_unit = 128;
  static constexpr std::size_t count = 6 * per_unit + 1;
  std::array<double, count> high;  ///< of the tail, falling
  std::array<double, count> low;
  std::array<DoubleDouble, count> inverse_slope;

  static double place(std::size_t k) { return static_cast<double>(k) / per_unit; }

  Nodes() {
    for (std::size_t k = 0; k < count; ++k) {
      const auto at_node = tail(place(k));
      high[k] = at_node.high;
      low[k] = at_node.low;
      inverse_slope[k] = DoubleDouble(1.0) / slope(place(k));
    }
  }
};

/// The inverse above the smallest tail of the nodes. With v = (tail - fraction)/slope of the last node x before it, the
/// distance h from there solves E(h) = v, where E is the integral of exp(-2 x t - t^2) over t from 0 to h.
double inverse_from_node(double fraction) {
  static const Nodes nodes;
  const auto next = std::partition_point(nodes.high.begin(), nodes.high.end(), [&](double t) { return t >= fraction; });
  const auto k = static_cast<std::size_t>(next - nodes.high.begin()) - 1;
  const double x = Nodes::place(k);
  const auto v = (DoubleDouble(nodes.high[k], nodes.low[k]) - fraction) * nodes.inverse_slope[k];
  // The first terms of the inverse series leave less than 2e-7 of h.
  const double u = v.high;
  const double x2 = x * x;
  const double h = u + u * u * (x + u * ((1.0 + 4.0 * x2) * (1.0 / 3.0) + u * x * (7.0 + 12.0 * x2) * (1.0 / 6.0)));
  // exp(-2 x t - t^2) = sum of c_n t^n: E = h - x h^2 + rest, the first two terms of it precise.
  double before = 1.0;
  double c = -2.0 * x;
  double power = h;
  double slope_at_h = 1.0 + c * h;
  double rest = 0.0;
  for (int n = 2; n < 14; ++n) {
    const double following = -2.0 * (x * c + before) / n;
    before = c;
    c = following;
    power *= h;
    slope_at_h += c * power;
    rest += c * power * h / (n + 1);
  }
  const double left = ((v - h) + exact_product(h, h) * x - rest).high;
  // Halley's rule makes the error its third power, times less than 30.
  const double newton = left / slope_at_h;
  const auto sum = ordered_sum(x, h);
  return sum.high + (sum.low + newton / (1.0 - newton * (x + h)));
}

/// The inverse from 6 on.
double inverse_in_far_tail(double fraction) {
  // Within 4.5e-4. Source: Abramowitz and Stegun, 26.2.23.
  const double t = std::sqrt(-2.0 * log(0.5 * fraction));
  const double z =
      t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
  double x = z * (0.5 * std::numbers::sqrt2);
  // Halley's rule makes the error its third power, times less than 500.
  for (int n = 0; n < 2; ++n) {
    const double newton = (erfc_over_slope(x) - fraction / slope(x)).high;
    x += newton / (1.0 - newton * x);
  }
  return x;
}

}  // namespace

double erfc(double x) {
  if (std::isnan(x)) return x;
  if (x < 0.0) return x < -6.0 ? 2.0 : (2.0 - tail(-x)).high;
  return x > 28.0 ? 0.0 : tail(x).high;
}

double inverse_erfc(double fraction) {
  if (!(fraction >= 0.0 && fraction <= 2.0)) return std::numeric_limits<double>::quiet_NaN();
  if (fraction > 1.0) return -inverse_erfc(2.0 - fraction);
  if (fraction == 0.0) return std::numeric_limits<double>::infinity();
  constexpr double smallest_of_nodes = 2.2e-17;  // just above erfc(6)
  return fraction > smallest_of_nodes ? inverse_from_node(fraction) : inverse_in_far_tail(fraction);
}

}  // namespace repose::reproducible
