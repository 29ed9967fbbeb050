// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_continuum.hpp"

#include "repose/core/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose::theory {
namespace {

// The printed closed forms (54)-(57), independent of the code, which adds lengths of diagonals.
TEST(PileContinuum, EqualsThePrintedForms) {
  for (const double degrees : {0.001, 0.5, 7.0, 23.4, 30.0, 41.7, 55.0, 59.9}) {
    const double a = radians(degrees);
    const double from_left = std::sin(2.0 * std::numbers::pi / 3.0 - a);
    const double from_right = std::sin(std::numbers::pi / 3.0 - a);
    const double rounding =
        std::max(1e-13, 1e-15 / from_right);  // rounding of the printed forms, which subtract angles
    const double x_centre = 0.5 * std::tan(a) * (1.0 / std::tan(a) - 1.0 / std::numbers::sqrt3);
    for (const double x : {0.1 * x_centre, 0.7 * x_centre, 0.5 * (x_centre + 0.5), 0.49}) {
      const bool outer = x <= x_centre;
      const double normal = outer ? std::numbers::sqrt3 * x * std::sin(a) * std::cos(a) / (2.0 * from_left * from_right)
                                  : std::sin(a) / (2.0 * from_left);
      const double shear = outer ? -x * std::sin(a) * std::sin(a) / (2.0 * std::numbers::sqrt3 * from_left * from_right)
                                 : (x - 0.5) * std::sin(a) / (std::numbers::sqrt3 * from_left);
      const PileContinuum model{.slope_deg = degrees};
      for (const double side : {1.0, -1.0}) {
        const auto force = base_force(model, side > 0.0 ? x : 1.0 - x);
        EXPECT_NEAR(force.normal, normal, rounding * normal) << degrees << ' ' << x;
        EXPECT_NEAR(force.shear, side * shear, rounding * std::abs(shear)) << degrees << ' ' << x;
      }
    }
  }
}

// The profile is piecewise linear, so trapezia between its corners integrate it exactly. A pile of area tan(a)/4 has
// lines at a distance of sqrt(3)/2 with chi per length, so its weight is tan(a) / (2 sqrt 3).
TEST(PileContinuum, CarriesTheWeight) {
  for (const double degrees : {0.5, 23.4, 30.0, 59.9}) {
    const PileContinuum model{.slope_deg = degrees};
    const double x_centre = 0.5 * (1.0 - std::tan(radians(degrees)) / std::numbers::sqrt3);
    const double plateau = base_force(model, 0.5).normal;
    const double weight = plateau * (1.0 - x_centre);
    EXPECT_NEAR(weight, std::tan(radians(degrees)) / (2.0 * std::numbers::sqrt3), 1e-13 * weight) << degrees;
  }
}

// Flat piles are hydrostatic except at the feet: the force on a diagonal is its length, N = chi g times the height over
// cos(30), and the shear force is smaller by the square of the slope. Towards 60 degrees the plateau covers the whole
// base, as in the equilateral pile, (42): N = chi g B/2, H = chi g (x - B/2)/sqrt(3), (44).
TEST(PileContinuum, Limits) {
  const PileContinuum flat{.slope_deg = 0.001};
  const double slope = radians(flat.slope_deg);
  for (const double x : {0.1, 0.3, 0.4}) {
    const auto force = base_force(flat, x);
    const double hydrostatic = 2.0 / std::numbers::sqrt3 * x * slope;
    EXPECT_NEAR(force.normal, hydrostatic, 1e-9 * hydrostatic) << x;
    EXPECT_NEAR(force.shear, -2.0 / 3.0 / std::numbers::sqrt3 * x * slope * slope, 1e-8 * hydrostatic * slope) << x;
  }
  const PileContinuum steep{.slope_deg = 60.0 - 1e-9};
  for (const double x : {0.01, 0.3, 0.5, 0.9}) {
    const auto force = base_force(steep, x);
    EXPECT_NEAR(force.normal, 0.5, 1e-9) << x;
    EXPECT_NEAR(force.shear, (x - 0.5) / std::numbers::sqrt3, 1e-9) << x;
  }
}

// The numbers agree with a fine table, and the plateau ends at x_c.
TEST(PileContinuum, NumbersAreThoseOfTheProfile) {
  for (const double degrees : {2.0, 30.0, 58.0}) {
    const PileContinuum model{.slope_deg = degrees, .points = 200'001};
    const auto table = evaluate(model);
    const auto& normal = table.column("normal").values;
    double weight = 0.0;
    for (const double force : normal) weight += force / 200'000.0;
    EXPECT_NEAR(table.number("weight"), weight, 1e-9 * weight) << degrees;  // trapezia across a kink
    const double x_c = table.number("x_c");
    EXPECT_NEAR(x_c + table.number("plateau_half_width"), 0.5, 1e-15) << degrees;
    EXPECT_LT(base_force(model, x_c - 1e-6).normal, table.number("plateau_normal") * (1.0 - 1e-8)) << degrees;
    EXPECT_NEAR(base_force(model, x_c + 1e-6).normal, table.number("plateau_normal"), 1e-15) << degrees;
  }
}

}  // namespace
}  // namespace repose::theory
