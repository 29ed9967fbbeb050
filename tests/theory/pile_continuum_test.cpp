// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_continuum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose::theory {
namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

// The printed closed forms (54)-(57), written down apart from the code, which adds lengths of diagonals.
TEST(PileContinuum, EqualsThePrintedForms) {
  for (const double degrees : {0.5, 7.0, 23.4, 30.0, 41.7, 55.0, 59.9}) {
    const double a = radians(degrees);
    const double from_left = std::sin(2.0 * std::numbers::pi / 3.0 - a);
    const double from_right = std::sin(std::numbers::pi / 3.0 - a);
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
        EXPECT_NEAR(force.normal, normal, 1e-13 * normal) << degrees << ' ' << x;
        EXPECT_NEAR(force.shear, side * shear, 1e-13 * normal) << degrees << ' ' << x;
      }
    }
  }
}

// The profile is piecewise linear: trapezia between its corners integrate it exactly. The pile of area tan(a)/4 has
// lines a distance sqrt(3)/2 apart of chi per length: it weighs tan(a) / (2 sqrt 3).
TEST(PileContinuum, CarriesTheWeight) {
  for (const double degrees : {0.5, 23.4, 30.0, 59.9}) {
    const PileContinuum model{.slope_deg = degrees};
    const double x_centre = 0.5 * (1.0 - std::tan(radians(degrees)) / std::numbers::sqrt3);
    const double plateau = base_force(model, 0.5).normal;
    const double weight = plateau * (1.0 - x_centre);
    EXPECT_NEAR(weight, std::tan(radians(degrees)) / (2.0 * std::numbers::sqrt3), 1e-13 * weight) << degrees;
  }
}

}  // namespace
}  // namespace repose::theory
