// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/double_double.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

/// Elementary functions to about 2^-96, for functions that round once at their end and for tables made by the compiler.
/// Callers handle infinities, NaN and domains. Validated by tests/unit/reproducible_math_test.cpp.
namespace repose {

/// A value times 2^exponent.
struct ScaledDoubleDouble {
  DoubleDouble value;
  int exponent = 0;
};

namespace constants {

// Exact in parts: a whole number of up to 11 bits times the first part of ln 2 is exact, and one of up to 20 bits times
// the first two parts of pi/2.
inline constexpr double ln2_first = 0x1.62e42fefa3800p-1;
inline constexpr DoubleDouble ln2_rest{0x1.ef35793c76730p-45, 0x1.f97b57a079a19p-103};
inline constexpr double half_pi_first = 0x1.921fb54400000p+0;
inline constexpr double half_pi_second = 0x1.0b4611a600000p-34;
inline constexpr DoubleDouble half_pi_rest{0x1.3198a2e037073p-69, 0x1.129024e088a68p-123};

/// 1/n!
inline constexpr auto inverse_factorials = [] {
  std::array<DoubleDouble, 30> table{1.0};
  for (std::size_t n = 1; n < table.size(); ++n) table[n] = table[n - 1] / static_cast<double>(n);
  return table;
}();

/// 1/(2n + 1)
inline constexpr auto odd_reciprocals = [] {
  std::array<DoubleDouble, 22> table;
  for (std::size_t n = 0; n < table.size(); ++n) table[n] = DoubleDouble(1.0) / static_cast<double>(2 * n + 1);
  return table;
}();

}  // namespace constants

/// The whole number nearest to x, |x| < 2^31.
constexpr int nearest(double x) { return static_cast<int>(x < 0.0 ? x - 0.5 : x + 0.5); }

/// 2^k, k from -1022 to 1023.
constexpr double power_of_two(int k) { return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52); }

/// e^x, |x| < 1000. The remainder after whole ln 2 is divided by 2^9, and e^r - 1 doubled as often.
constexpr ScaledDoubleDouble exponential(const DoubleDouble& x) {
  const int k = nearest(x.high * 0x1.71547652b82fep+0);
  const double whole = k;
  const DoubleDouble r = (x - whole * constants::ln2_first - constants::ln2_rest * whole) * 0x1p-9;
  DoubleDouble sum;
  for (std::size_t n = 10; n > 0; --n) sum = (sum + constants::inverse_factorials[n]) * r;
  for (int n = 0; n < 9; ++n) sum = sum * 2.0 + sum * sum;
  return {sum + 1.0, k};
}

/// Logarithm of x > 0, x.high a normal number, from log m = 2 artanh((m - 1)/(m + 1)) of x = m 2^k.
constexpr DoubleDouble logarithm(const DoubleDouble& x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t exponent_bits = 0xfffULL << 52;
  // Counted from the root of 1/2, so that m lies between it and that of 2.
  const auto bits = std::bit_cast<std::uint64_t>(x.high);
  const std::uint64_t shift = (bits - root_half) & exponent_bits;
  const int k = static_cast<int>(static_cast<std::int64_t>(shift) >> 52);
  const double high = std::bit_cast<double>(bits - shift);
  const double low = x.low * power_of_two(-k / 2) * power_of_two(-(k - k / 2));
  const DoubleDouble m{high, low};
  const auto s = (m - 1.0) / (m + 1.0);
  const auto square = s * s;
  DoubleDouble sum;
  for (std::size_t n = constants::odd_reciprocals.size(); n > 0; --n) {
    sum = sum * square + constants::odd_reciprocals[n - 1];
  }
  const double whole = k;
  return sum * s * 2.0 + constants::ln2_rest * whole + whole * constants::ln2_first;
}

/// Sine and cosine of |x| < 1e6.
constexpr std::pair<DoubleDouble, DoubleDouble> sine_and_cosine(double x) {
  const int k = nearest(x * 0x1.45f306dc9c883p-1);
  const double whole = k;
  const DoubleDouble r = DoubleDouble(x - whole * constants::half_pi_first) - whole * constants::half_pi_second -
                         constants::half_pi_rest * whole;
  const auto square = r * r;
  DoubleDouble sine;
  DoubleDouble cosine;
  for (std::size_t n = 14; n > 0; --n) {
    sine = constants::inverse_factorials[2 * n - 1] - square * sine;
    cosine = constants::inverse_factorials[2 * n - 2] - square * cosine;
  }
  sine = sine * r;
  switch (static_cast<unsigned>(k) % 4U) {
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    case 3:
      return {-cosine, sine};
    default:
      return {sine, cosine};
  }
}

}  // namespace repose
