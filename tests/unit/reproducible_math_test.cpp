// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/reproducible_math.hpp"

#include "repose/core/double_double_functions.hpp"
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace repose {
namespace {

// The oracle is the C library in long double. Its functions are within a few units in the last of 64 places, of which
// 2048 make one of double.
using Long = long double;
static_assert(std::numeric_limits<Long>::digits >= 64, "the tests need a longer number as oracle");

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Range {
  double low;
  double high;
  double at(std::uint64_t k, std::uint32_t draw = 0) const {
    return low + (high - low) * uniform(1, Purpose::parking, k, draw);
  }
};

double unit_in_last_place(Long x) {
  int exponent = 0;
  std::frexp(static_cast<double>(x), &exponent);
  return std::ldexp(1.0, std::max(exponent, std::numeric_limits<double>::min_exponent) - 53);
}

/// Distance of a double from the precise value, in units of its last place: 0.5 at most where it is correctly rounded.
double units_off(double value, Long precise) {
  return static_cast<double>(std::fabs(static_cast<Long>(value) - precise)) / unit_in_last_place(precise);
}

using Function = std::function<double(double)>;
using LongFunction = std::function<Long(Long)>;

double most_units_off(const Function& function, const LongFunction& precise, const Range& range, int count = 5000) {
  double most = 0.0;
  for (int k = 0; k < count; ++k) {
    const double x = range.at(static_cast<std::uint64_t>(k));
    most = std::max(most, units_off(function(x), precise(x)));
  }
  return most;
}

// Correct rounding is 0.5; the oracle is off by up to 2 of its own units, a thousandth of ours.
constexpr double correctly_rounded = 0.501;

TEST(ReproducibleMath, TheComparisonSeesOneUnit) {
  const auto next = [](double x) { return std::nextafter(reproducible::exp(x), infinity); };
  EXPECT_GT(most_units_off(
                next, [](Long x) { return std::exp(x); }, {-1.0, 1.0}, 100),
            1.0);
  EXPECT_EQ(units_off(1.0 + 0x1p-52, 1.0L), 1.0);
  EXPECT_EQ(units_off(1.0, 1.0L + 0x1p-53L), 0.5);
}

TEST(ReproducibleMath, Exp) {
  const auto precise = [](Long x) { return std::exp(x); };
  for (const auto& range : {Range{-1.0, 1.0}, Range{-40.0, 40.0}, Range{-708.0, 709.7}, Range{-1e-9, 1e-9}}) {
    EXPECT_LT(most_units_off(reproducible::exp, precise, range), correctly_rounded);
  }
  // Rounded twice below the smallest normal number.
  EXPECT_LE(most_units_off(reproducible::exp, precise, {-745.0, -709.0}), 1.0);
}

TEST(ReproducibleMath, Log) {
  const auto precise = [](Long x) { return std::log(x); };
  for (const auto& range : {Range{0.0, 10.0}, Range{0.99, 1.01}, Range{1e-310, 1e-307}, Range{1e300, 1e308}}) {
    EXPECT_LT(most_units_off(reproducible::log, precise, range), correctly_rounded);
  }
  const auto precise1p = [](Long x) { return std::log1p(x); };
  for (const auto& range : {Range{-0.99, 3.0}, Range{-1e-6, 1e-6}, Range{-1e-20, 1e-20}}) {
    EXPECT_LT(most_units_off(reproducible::log1p, precise1p, range), correctly_rounded);
  }
}

TEST(ReproducibleMath, SinCosTan) {
  for (const auto& range : {Range{-7.0, 7.0}, Range{-1e-6, 1e-6}, Range{-1e6, 1e6}}) {
    EXPECT_LT(most_units_off(
                  reproducible::sin, [](Long x) { return std::sin(x); }, range),
              correctly_rounded);
    EXPECT_LT(most_units_off(
                  reproducible::cos, [](Long x) { return std::cos(x); }, range),
              correctly_rounded);
    EXPECT_LT(most_units_off(
                  reproducible::tan, [](Long x) { return std::tan(x); }, range),
              correctly_rounded);
  }
}

TEST(ReproducibleMath, Hypot) {
  for (const double scale : {1.0, 1e-300, 1e300}) {
    const double y = 0.7 * scale;
    EXPECT_LT(most_units_off([&](double x) { return reproducible::hypot(x, y); },
                             [&](Long x) { return std::hypot(x, static_cast<Long>(y)); }, {-scale, scale}),
              correctly_rounded);
  }
}

// y log x is known to 2^-66 of it, and 2^-59 comes from the exponential: 0.5 + 2^-6 at the very most.
TEST(ReproducibleMath, Pow) {
  struct Case {
    Range x;
    Range y;
  };
  for (const auto& [x, y] :
       {Case{{0.3, 1.3}, {1.0, 60.0}}, Case{{0.0, 100.0}, {-3.0, 3.0}}, Case{{0.999, 1.001}, {-1e5, 1e5}},
        Case{{1e-300, 1e-290}, {-1.0, 1.0}}, Case{{1e-310, 1e-307}, {-0.9, 0.9}}, Case{{1.0, 2.0}, {1.0, 1000.0}}}) {
    double most = 0.0;
    for (std::uint64_t k = 0; k < 5000; ++k) {
      const double base = x.at(k);
      const double exponent = y.at(k, 1);
      most = std::max(most, units_off(reproducible::pow(base, exponent),
                                      std::pow(static_cast<Long>(base), static_cast<Long>(exponent))));
    }
    EXPECT_LT(most, 0.516);
  }
}

// The oracle of erfc is off by up to 5 of its own units.
TEST(ReproducibleMath, Erfc) {
  const auto precise = [](Long x) { return std::erfc(x); };
  for (const auto& range : {Range{-7.0, 4.5}, Range{3.9, 26.0}, Range{-1e-6, 1e-6}}) {
    EXPECT_LT(most_units_off(reproducible::erfc, precise, range), 0.504);
  }
}

// What is left of the equation, over the slope, is the error of x. Near fraction = 1 it comes from erf.
TEST(ReproducibleMath, InverseErfc) {
  constexpr Long slope_at_0 = 1.1283791670955125738962L;
  const auto worst = [&](const Range& range) {
    double most = 0.0;
    for (std::uint64_t k = 0; k < 5000; ++k) {
      const double fraction = range.at(k);
      const Long x = reproducible::inverse_erfc(fraction);
      const Long left = fraction > 0.5 ? (1.0L - fraction) - std::erf(x) : std::erfc(x) - fraction;
      most = std::max(most,
                      static_cast<double>(std::fabs(left / (slope_at_0 * std::exp(-x * x)))) / unit_in_last_place(x));
    }
    return most;
  };
  for (const auto& range : {Range{0.0, 1.0}, Range{0.5, 1.5}, Range{1.0, 1.9}, Range{1.0 - 1e-9, 1.0 + 1e-9},
                            Range{0.0, 1e-6}, Range{2e-17, 2.5e-17}, Range{0.0, 1e-200}}) {
    EXPECT_LT(worst(range), 0.505);
  }
}

void expect_as_std(double value, double standard, const char* name, double x) {
  if (std::isnan(standard)) {
    EXPECT_TRUE(std::isnan(value)) << name << " of " << x;
  } else {
    EXPECT_EQ(value, standard) << name << " of " << x;
    EXPECT_EQ(std::signbit(value), std::signbit(standard)) << name << " of " << x;
  }
}

TEST(ReproducibleMath, EndsOfDomains) {
  for (const double x : {0.0, -0.0, infinity, -infinity, not_a_number, 1000.0, -1000.0}) {
    expect_as_std(reproducible::exp(x), std::exp(x), "exp", x);
    expect_as_std(reproducible::erfc(x), std::erfc(x), "erfc", x);
    expect_as_std(reproducible::hypot(x, 0.0), std::hypot(x, 0.0), "hypot", x);
    expect_as_std(reproducible::hypot(not_a_number, x), std::hypot(not_a_number, x), "hypot", x);
  }
  for (const double x : {0.0, -0.0, 1.0, -1.0, infinity, -infinity, not_a_number, 1e-320}) {
    if (x != 1e-320) expect_as_std(reproducible::log(x), std::log(x), "log", x);
    if (x != 1.0) expect_as_std(reproducible::log1p(x), std::log1p(x), "log1p", x);
  }
  for (const double x : {0.0, -0.0, infinity, -infinity, not_a_number, 1e-320, -1e-10}) {
    expect_as_std(reproducible::sin(x), std::sin(x), "sin", x);
    expect_as_std(reproducible::cos(x), std::cos(x), "cos", x);
    expect_as_std(reproducible::tan(x), std::tan(x), "tan", x);
  }
  EXPECT_TRUE(std::isnan(reproducible::sin(2e6)));
  EXPECT_EQ(reproducible::inverse_erfc(0.0), infinity);
  EXPECT_EQ(reproducible::inverse_erfc(1.0), 0.0);
  EXPECT_EQ(reproducible::inverse_erfc(2.0), -infinity);
  EXPECT_TRUE(std::isnan(reproducible::inverse_erfc(2.1)));
  EXPECT_TRUE(std::isnan(reproducible::inverse_erfc(not_a_number)));
}

TEST(ReproducibleMath, PowersOfUnusualNumbers) {
  const double bases[] = {0.0, 0.5, 1.0 - 0x1p-53, 1.0, 1.0 + 0x1p-52, 4.0, 1e300, infinity, not_a_number};
  const double exponents[] = {0.0,  -0.0, 1.0,   -1.0,  2.0,      0.5,       1e5,
                              -1e5, 1e20, -1e20, 1e-25, infinity, -infinity, not_a_number};
  for (const double x : bases) {
    for (const double y : exponents) {
      const double value = reproducible::pow(x, y);
      const double standard = std::pow(x, y);
      EXPECT_TRUE(value == standard || (std::isnan(value) && std::isnan(standard)) ||
                  std::fabs(value - standard) <= 0x1p-52 * standard)
          << x << "^" << y << ": " << value << ", not " << standard;
    }
  }
  EXPECT_TRUE(std::isnan(reproducible::pow(-1.0, 2.0)));
  EXPECT_EQ(reproducible::pow(0x1p-1070, 0.5), 0x1p-535);
  EXPECT_EQ(reproducible::pow(2.0, -1070.0), 0x1p-1070);
  EXPECT_EQ(reproducible::pow(2.0, 1023.0), 0x1p1023);
}

/// A number made of the bits of a function at many arguments.
std::uint64_t fingerprint(const Function& function, const Range& range) {
  std::uint64_t mixed = 0xcbf29ce484222325;
  for (std::uint64_t k = 0; k < 5000; ++k) {
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(function(range.at(k)))) * 0x9e3779b97f4a7c15;
    mixed ^= mixed >> 32;
  }
  return mixed;
}

// Every bit is fixed: another value here is another result of every run that uses the function.
TEST(ReproducibleMath, Bits) {
  EXPECT_EQ(fingerprint(reproducible::exp, {-40.0, 40.0}), 0x69c184eae575960bU);
  EXPECT_EQ(fingerprint(reproducible::log, {0.0, 10.0}), 0xa841419b77401a0dU);
  EXPECT_EQ(fingerprint(reproducible::log1p, {-0.9, 2.0}), 0x44dcca157a53001aU);
  EXPECT_EQ(fingerprint(reproducible::sin, {-7.0, 7.0}), 0xb9ee73548ba6c639U);
  EXPECT_EQ(fingerprint(reproducible::cos, {-7.0, 7.0}), 0x2c23c6b538ecaf20U);
  EXPECT_EQ(fingerprint(reproducible::tan, {-7.0, 7.0}), 0xbb8ed5eedc6307ebU);
  EXPECT_EQ(fingerprint([](double x) { return reproducible::hypot(x, 1.0); }, {0.0, 5.0}), 0xb46792830b3ba31aU);
  EXPECT_EQ(fingerprint([](double x) { return reproducible::pow(x, 25.5); }, {0.5, 1.5}), 0xb26e1f304ade2f42U);
  EXPECT_EQ(fingerprint([](double x) { return reproducible::pow(0.9, x); }, {-50.0, 50.0}), 0x2e3f77f42266ea6eU);
  EXPECT_EQ(fingerprint(reproducible::erfc, {-6.0, 10.0}), 0x360ab520e18e941eU);
  EXPECT_EQ(fingerprint(reproducible::inverse_erfc, {0.0, 2.0}), 0x006f66153bd7b085U);
}

// Sums and products of whole numbers of 53 bits are exact in 128 bits.
TEST(DoubleDouble, SumsAndProductsAreExact) {
  __extension__ using Wide = __int128;
  for (std::uint64_t k = 0; k < 10000; ++k) {
    const double a = std::floor(Range{-0x1p53, 0x1p53}.at(k));
    const double b = std::floor(Range{-0x1p40, 0x1p53}.at(k, 1));
    const auto product = exact_product(a, b);
    EXPECT_EQ(static_cast<Wide>(product.high) + static_cast<Wide>(product.low),
              static_cast<Wide>(a) * static_cast<Wide>(b));
    const auto sum = exact_sum(a, b);
    EXPECT_EQ(static_cast<Wide>(sum.high) + static_cast<Wide>(sum.low), static_cast<Wide>(a) + static_cast<Wide>(b));
    EXPECT_EQ(sum.high, a + b);
    const auto quotient = DoubleDouble(a) / b;
    const auto back = quotient * b - a;
    EXPECT_LT(std::fabs(back.high), 0x1p-101 * std::fabs(a));
  }
}

/// Relative distance of two numbers of about 106 bits.
double apart(const DoubleDouble& a, const DoubleDouble& b) { return std::fabs(((a - b) / b).high); }

// Values to 106 bits, by mpmath with 300.
TEST(DoubleDouble, ElementaryFunctions) {
  constexpr double close = 0x1p-96;
  const auto power = [](double x) {
    const auto found = exponential(x);
    return found.value * power_of_two(found.exponent);
  };
  EXPECT_LT(apart(power(1.0), {0x1.5bf0a8b145769p+1, 0x1.4d57ee2b1013ap-53}), close);
  EXPECT_LT(apart(power(-20.5), {0x1.57a3afeed00abp-30, 0x1.3f4d19cefc8abp-84}), close);
  EXPECT_LT(apart(logarithm(10.0), {0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53}), close);
  EXPECT_LT(apart(logarithm(0.75), {-0x1.269621134db92p-2, -0x1.e0efadd9db02bp-56}), close);
  EXPECT_LT(apart(logarithm(1e-200), {-0x1.cc845b54b54f2p+8, 0x1.8dc65fe0f133cp-46}), close);
  EXPECT_LT(apart(sine_and_cosine(1.0).first, {0x1.aed548f090ceep-1, 0x1.06374f484e288p-59}), close);
  EXPECT_LT(apart(sine_and_cosine(1.0).second, {0x1.14a280fb5068cp-1, -0x1.b71edcc9344bcp-55}), close);
  EXPECT_LT(apart(sine_and_cosine(1e5).first, {0x1.24daa9c527e96p-5, 0x1.c767d8e3e1ca8p-60}), close);
  EXPECT_LT(apart(sine_and_cosine(1e5).second, {-0x1.ffac3841b3da7p-1, -0x1.b085bf2c1a978p-56}), close);
  EXPECT_LT(apart(sine_and_cosine(-2.5).first, {-0x1.326af0dcfcab1p-1, 0x1.fd42734161659p-55}), close);
  // They are the inverse of each other.
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const double x = Range{0.5, 300.0}.at(k);
    EXPECT_LT(apart(logarithm(power(x)), x), 0x1p-94) << x;
  }
}

}  // namespace
}  // namespace repose
