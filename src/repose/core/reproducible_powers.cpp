// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/double_double_functions.hpp"
#include "repose/core/reproducible_math.hpp"

#include <cmath>
#include <limits>

/// x^y = e^(y log x) with tables of 128 entries: the logarithm within 2^-66 of it as a sum of two doubles, the
/// exponential within 2^-59 before it is rounded. exp is calculated again where that leaves its rounding in doubt.
/// Source of the method: Tang (1989, 1990), table-driven exponential and logarithm.
namespace repose::reproducible {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int table_bits = 7;
constexpr int table_size = 1 << table_bits;

// Mantissas begin here, at about 0.7057, so that 1 lies at a third of an interval of the table.
constexpr std::uint64_t first_mantissa = 0x3fe6955500000000;

/// An interval of mantissas m with centre c: 1/c rounded to few bits, so that m/c is exact in two doubles, and log c.
struct LogEntry {
  double inverse;
  double log_high;  ///< a multiple of 2^-42, so that its sum with whole ln 2 is exact
  double log_low;
};

constexpr std::uint64_t mantissa_of(int entry) {
  return first_mantissa + (static_cast<std::uint64_t>(entry) << (52 - table_bits));
}

constexpr double rounded_to(double x, double unit) {
  const double steps = x / unit;
  return static_cast<double>(static_cast<std::int64_t>(steps < 0.0 ? steps - 0.5 : steps + 0.5)) * unit;
}

constexpr auto log_table = [] {
  std::array<LogEntry, table_size> table{};
  for (int k = 0; k < table_size; ++k) {
    const double low = std::bit_cast<double>(mantissa_of(k));
    const double high = std::bit_cast<double>(mantissa_of(k + 1));
    // The interval that holds 1 has 1/c = 1 and log c = 0, so that small logarithms are precise too.
    const double inverse = low <= 1.0 && high > 1.0 ? 1.0 : rounded_to(2.0 / (low + high), 0x1p-10);
    const auto log = -logarithm(inverse);
    const double log_high = rounded_to(log.high, 0x1p-42);
    table[static_cast<std::size_t>(k)] = {inverse, log_high, (log - log_high).high};
  }
  return table;
}();

/// 2^(k/128) rounded to double, and the remainder as a fraction of it.
struct ExpEntry {
  double value;
  double rest;
};

constexpr auto exp_table = [] {
  std::array<ExpEntry, table_size> table{};
  for (int k = 0; k < table_size; ++k) {
    const double part = static_cast<double>(k) / table_size;
    const auto power = exponential(constants::ln2_rest * part + part * constants::ln2_first);
    // The exponent is 1 from 2^(1/2) on.
    const double scale = power_of_two(power.exponent);
    table[static_cast<std::size_t>(k)] = {power.value.high * scale, power.value.low / power.value.high};
  }
  return table;
}();

/// log(x 2^more) of a normal number x > 0.
DoubleDouble quick_logarithm(double x, int more) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t above = bits - first_mantissa;
  const auto& entry = log_table[(above >> (52 - table_bits)) % table_size];
  const auto exponent = static_cast<std::int64_t>(above) >> 52;
  const double whole = static_cast<double>(exponent + more);
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
  // r = m/c - 1, exact as a sum of two: m in 42 bits and the rest, each times the 11 bits of 1/c.
  const double front = std::bit_cast<double>(std::bit_cast<std::uint64_t>(m) & ~0x7ffULL);
  const double r_front = front * entry.inverse - 1.0;
  const double r_rest = (m - front) * entry.inverse;
  const double r = r_front + r_rest;
  const double r_low = (r_front - r) + r_rest;
  // whole ln 2 + log c + r - r^2/2 to 2^-68, the square from halves.
  const double big = whole * constants::ln2_first + entry.log_high;
  const double small = whole * constants::ln2_rest.high + entry.log_low;
  const auto sum = exact_sum(big, r);
  const double half = std::bit_cast<double>(std::bit_cast<std::uint64_t>(r) & ~((1ULL << 27) - 1));
  const double square = -0.5 * half * half;
  const double square_low = -0.5 * (r - half) * (r + half);
  const auto with_square = ordered_sum(sum.high, square);
  const double r2 = r * r;
  // The series from r^3 on; |r| < 0.0053.
  const double series =
      r * r2 *
      ((1.0 / 3.0 - r * (1.0 / 4.0)) +
       r2 * ((1.0 / 5.0 - r * (1.0 / 6.0)) + r2 * ((1.0 / 7.0 - r * (1.0 / 8.0)) + r2 * (1.0 / 9.0))));
  const double low = small + sum.low + with_square.low + square_low + (r_low - r * r_low) + series;
  return ordered_sum(with_square.high, low);
}

// ln 2 in 36 bits, so that its products with up to 2^17 steps of 1/128 are exact.
constexpr double step_first = 0x1.62e42fefap-1 / table_size;
constexpr double step_rest = ((constants::ln2_first - 0x1.62e42fefap-1) + constants::ln2_rest.high) / table_size;

/// A number (high + low) 2^exponent, |low| < |high|/128.
struct Parts {
  double high;
  double low;
  int exponent;
};

/// e^(x.high + x.low), |x.high| < 1100, before it is rounded: within 2^-59 of it.
Parts quick_exponential(const DoubleDouble& x) {
  constexpr double shift = 0x1.8p52;  // to the nearest whole number and back
  const double steps = (x.high * (0x1.71547652b82fep+0 * table_size) + shift) - shift;
  const auto whole = static_cast<std::int64_t>(steps);
  const double r = (x.high - steps * step_first) + (x.low - steps * step_rest);
  const auto& entry = exp_table[static_cast<std::uint64_t>(whole) % table_size];
  const double r2 = r * r;
  const double series =
      entry.rest + r +
      r2 * ((1.0 / 2.0 + r * (1.0 / 6.0)) + r2 * ((1.0 / 24.0 + r * (1.0 / 120.0)) + r2 * (1.0 / 720.0)));
  return {entry.value, entry.value * series, static_cast<int>(whole >> table_bits)};
}

double scaled(double value, int exponent) {
  if (exponent >= -1021 && exponent <= 1022) return value * power_of_two(exponent);
  return std::ldexp(value, exponent);
}

/// The power from the logarithm of its base.
double power(const DoubleDouble& log, double y) {
  const auto product = exact_product(y, log.high);
  if (!(std::fabs(product.high) < 1100.0)) return product.high > 0.0 ? infinity : 0.0;
  const auto parts = quick_exponential({product.high, product.low + y * log.low});
  return scaled(parts.high + parts.low, parts.exponent);
}

constexpr double tiny_exponent = 0x1p-65;  // all powers round to 1
constexpr double huge_exponent = 0x1p65;   // all powers overflow or underflow, even of the numbers next to 1

[[gnu::noinline, gnu::cold]] double unusual_pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (std::isnan(x) || std::isnan(y) || x < 0.0) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0.0 || x == infinity) return (x == 0.0) == (y > 0.0) ? 0.0 : infinity;
  if (std::fabs(y) < tiny_exponent) return 1.0;
  if (std::fabs(y) > huge_exponent) return (x > 1.0) == (y > 0.0) ? infinity : 0.0;
  constexpr int shift = 54;  // makes x a normal number
  return power(quick_logarithm(std::ldexp(x, shift), -shift), y);
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 710.0) return infinity;
  if (x < -746.0) return 0.0;
  const auto parts = quick_exponential(x);
  const auto sum = ordered_sum(parts.high, parts.low);
  const double doubt = 0x1p-59 * sum.high;
  const double rounded = sum.high + (sum.low - doubt);
  if (rounded == sum.high + (sum.low + doubt)) return scaled(rounded, parts.exponent);
  const auto precise = exponential(x);
  return std::ldexp(precise.value.high, precise.exponent);
}

double pow(double x, double y) {
  const double size = std::fabs(y);
  const bool usual =
      x >= std::numeric_limits<double>::min() && x < infinity && size >= tiny_exponent && size <= huge_exponent;
  return usual ? power(quick_logarithm(x, 0), y) : unusual_pow(x, y);
}

}  // namespace repose::reproducible
