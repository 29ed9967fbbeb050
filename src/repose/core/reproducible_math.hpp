// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Functions whose bits depend on their arguments alone. Those of the C library differ in the last bit between
/// processors with and without fused multiply-add, and between its versions; all that the state of grains depends on
/// calls these instead. They are made of sums, products and quotients of doubles and of std::sqrt, which IEEE 754 fixes
/// to the bit.
///
/// Infinities, NaN and numbers outside a domain give what the functions of std do. Results below the smallest normal
/// number, 2.2e-308, are within one unit of their last place, 4.9e-324. Otherwise all but pow, erfc and its inverse are
/// correctly rounded, unless the exact result is within 1e-9 units in the last place of the middle of two doubles.
/// A compiler may take for granted that they look at their arguments alone (gnu::const): a call within a loop over
/// pairs then leaves what the loop has in registers. Validated by tests/unit/reproducible_math_test.cpp.
namespace repose::reproducible {

[[gnu::const]] double exp(double x);
[[gnu::const]] double log(double x);
[[gnu::const]] double log1p(double x);

/// Angles are in radians, |x| < 1e6; the result is NaN beyond.
[[gnu::const]] double sin(double x);
[[gnu::const]] double cos(double x);
[[gnu::const]] double tan(double x);

/// x^y for x >= 0, within 0.52 units in the last place: fast enough for the inner loop. NaN for x < 0.
[[gnu::const]] double pow(double x, double y);

/// The root of x^2 + y^2.
[[gnu::const]] double hypot(double x, double y);

/// The complementary error function, 2/sqrt(pi) times the integral of exp(-t^2) from x to infinity.
[[gnu::const]] double erfc(double x);

/// The x at which erfc(x) = fraction, for fractions between 0 and 2; +-infinity at 0 and 2.
[[gnu::const]] double inverse_erfc(double fraction);

}  // namespace repose::reproducible
