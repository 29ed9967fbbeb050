// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/osl_cone.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/numbers.hpp"
#include "repose/theory/cone_stress.hpp"
#include "repose/theory/linear_wedge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace repose::theory {
namespace {

/// Cones of every closure and hoop stress that has a solution, from flat to steep.
std::vector<OslCone> cones() {
  std::vector<OslCone> all;
  for (const double angle : {1.0, 21.0, 36.0, 80.0}) {
    for (const char* const hoop : {"radial", "minor"}) {
      all.push_back({.model = "fpa", .hoop = hoop, .angle_deg = angle});
      all.push_back({.model = "fpa", .hoop = hoop, .angle_deg = angle, .slope_deg = std::max(1.0, 0.7 * angle)});
      all.push_back({.model = "bcc", .hoop = hoop, .angle_deg = angle});
    }
    if (angle < 37.0) all.push_back({.model = "fpa", .hoop = "mean", .angle_deg = angle});
    all.push_back({.model = "custom", .angle_deg = angle, .mu = -0.4});
  }
  all.push_back({.model = "custom", .angle_deg = 30.0, .slope_deg = 25.0, .mu = 0.3, .eta = 0.5});
  all.push_back({.model = "custom", .hoop = "minor", .angle_deg = 30.0, .slope_deg = 25.0, .mu = -0.3, .eta = 0.8});
  for (auto& cone : all) cone.points = 2001;
  return all;
}

std::string title_of(const OslCone& cone) {
  return cone.model + ' ' + cone.hoop + ' ' + std::to_string(cone.angle_deg) + ' ';
}

double tan_slope(const OslCone& cone) { return std::tan(radians(cone.slope_deg.value_or(cone.angle_deg))); }

/// A fourth-order central difference of a column along S.
double along(const std::vector<double>& column, std::size_t i) {
  const double step = 1.0 / static_cast<double>(column.size() - 1);
  return (8.0 * (column[i + 1] - column[i - 1]) - column[i + 2] + column[i - 2]) / (12.0 * step);
}

// Both equations of equilibrium from the printed columns; d/dz of z f(S) is f - S f'. Differences do not cross the
// characteristic. Their error is that of the solver, 1e-10, over a step of 5e-4.
TEST(OslCone, BaseIsInEquilibrium) {
  for (const auto& cone : cones()) {
    const auto table = evaluate(cone);
    const double t = tan_slope(cone);
    const double s_inner = table.number("s_inner");
    const auto& s = table.column("r_over_R").values;
    const auto& normal = table.column("normal").values;
    const auto& shear = table.column("shear").values;
    const auto& radial = table.column("radial").values;
    const auto& hoop = table.column("hoop").values;
    int checked = 0;
    for (std::size_t i = 60; i + 3 < s.size(); i += 3) {
      if (std::abs(s[i] - s_inner) < 0.01) continue;
      const double across = t * along(radial, i) + shear[i] - s[i] * along(shear, i) + t * (radial[i] - hoop[i]) / s[i];
      const double down = t * along(shear, i) + normal[i] - s[i] * along(normal, i) + t * shear[i] / s[i] - 1.0;
      ASSERT_NEAR(across, 0.0, 1e-6) << title_of(cone) << s[i];
      ASSERT_NEAR(down, 0.0, 1e-6) << title_of(cone) << s[i];
      ++checked;
    }
    EXPECT_GT(checked, 500) << title_of(cone);
  }
}

// Balances of the whole cone and of half of it, by quadrature. Neither is an equation that the solver integrates.
TEST(OslCone, CarriesItsWeightAndHalfOfItIsBalanced) {
  for (const auto& cone : cones()) {
    const auto table = evaluate(cone);
    EXPECT_NEAR(table.number("weight_error"), 0.0, 1e-9) << title_of(cone);
    EXPECT_NEAR(table.number("half_cone_error"), 0.0, 1e-9) << title_of(cone);
    // Simpson's rule over the printed column: its error at the characteristic is below the step squared.
    const auto& s = table.column("r_over_R").values;
    const auto& normal = table.column("normal").values;
    double force = 0.0;
    for (std::size_t i = 0; i + 2 < s.size(); i += 2) {
      force += (normal[i] * s[i] + 4.0 * normal[i + 1] * s[i + 1] + normal[i + 2] * s[i + 2]) / 3.0 * (s[1] - s[0]);
    }
    const double radius = 1.0 / tan_slope(cone);
    EXPECT_NEAR(2.0 * std::numbers::pi * radius * radius * force, table.number("weight"), 1e-6 * table.number("weight"))
        << title_of(cone);
  }
}

// The surface bears no stress, the axis no shear, and on the axis both horizontal stresses are equal.
TEST(OslCone, HasTheEdgesAndTheClosureOfACone) {
  for (const auto& cone : cones()) {
    const auto table = evaluate(cone);
    const auto& normal = table.column("normal").values;
    const auto& shear = table.column("shear").values;
    const auto& radial = table.column("radial").values;
    const auto& hoop = table.column("hoop").values;
    EXPECT_EQ(shear.front(), 0.0);
    EXPECT_NEAR(hoop.front(), radial.front(), 1e-15) << title_of(cone);
    for (const auto* stress : {&normal, &shear, &radial, &hoop}) EXPECT_EQ(stress->back(), 0.0);
    for (std::size_t i = 0; i < normal.size(); ++i) {
      EXPECT_NEAR(radial[i], table.number("eta") * normal[i] + table.number("mu") * shear[i], 1e-14 * (1.0 + radial[i]))
          << title_of(cone) << i;
      const double mean = 0.5 * (normal[i] + radial[i]);
      const double radius = std::hypot(0.5 * (normal[i] - radial[i]), shear[i]);
      const double expected = cone.hoop == "radial" ? radial[i] : cone.hoop == "minor" ? mean - radius : mean;
      EXPECT_NEAR(hoop[i], expected, 1e-14 * (mean + radius) + 1e-16) << title_of(cone) << i;
    }
  }
}

TEST(OslCone, StressesAreContinuousOnTheCharacteristic) {
  for (const double angle : {2.0, 30.0, 60.0}) {
    for (const auto hoop : {Hoop::radial, Hoop::minor}) {
      const double t = std::tan(radians(angle));
      const ConeStress cone{{fixed_principal_axis(t), hoop}, t};
      EXPECT_NEAR(cone.shear_jump(), 0.0, 1e-10) << angle;
    }
  }
}

// Where the difference of horizontal stresses is linear in the shear, kappa sigma_rz, the inner stresses are linear:
// sigma_rz = h1 S, sigma_zz = n0 - (mu + kappa)/eta h1 S, h1 = (1 - n0)/(2 T). BCC with a radial hoop stress has a
// plateau.
TEST(OslCone, LinearClosuresAreLinearInside) {
  for (const double angle : {5.0, 30.0, 36.0}) {
    const double s = std::sin(radians(angle));
    const double c = std::cos(radians(angle));
    const double t = s / c;
    struct Case {
      OslCone cone;
      double kappa;
    };
    for (const auto& [cone, kappa] : {Case{{.model = "fpa", .angle_deg = angle}, 0.0},
                                      Case{{.model = "fpa", .hoop = "minor", .angle_deg = angle}, (1.0 - s) / c},
                                      Case{{.model = "fpa", .hoop = "mean", .angle_deg = angle}, -t},
                                      Case{{.model = "bcc", .angle_deg = angle}, 0.0}}) {
      const auto table = evaluate(cone);
      const double n0 = table.number("centre_normal");
      const double h1 = 0.5 * (1.0 - n0) / t;
      for (std::size_t i = 0; i < 201; ++i) {
        const double at = table.column("r_over_R").values[i];
        if (at > table.number("s_inner")) break;
        const double slope = -(table.number("mu") + kappa) / table.number("eta") * h1;
        EXPECT_NEAR(table.column("normal").values[i], n0 + slope * at, 1e-10) << title_of(cone) << at;
        EXPECT_NEAR(table.column("shear").values[i], h1 * at, 1e-10) << title_of(cone) << at;
      }
    }
  }
}

// A fixed principal axis with the minor hoop stress has a closed form (docs/theory/osl-cone.md): sigma_3 is linear
// along the minor axis and r (sigma_1 - sigma_3) quadratic along the major axis.
TEST(OslCone, FixedAxisWithTheMinorHoopStressHasItsClosedForm) {
  for (const double angle : {1.0, 8.0, 19.0, 30.0, 33.0, 47.0, 66.0, 80.0}) {
    const double phi = radians(angle);
    const double lean = 0.25 * std::numbers::pi - 0.5 * phi;
    const double t = std::tan(phi);
    const double fraction = std::tan(lean) / (std::tan(lean) + t);
    const double rise = std::cos(lean) - fraction * (std::cos(lean) - t * std::sin(lean));
    const auto table = evaluate(OslCone{.hoop = "minor", .angle_deg = angle, .points = 1001});
    EXPECT_NEAR(table.number("centre_normal"), 1.0 - std::sin(phi), 1e-9) << angle;
    EXPECT_NEAR(table.number("s_inner"), t * std::tan(lean), 1e-14) << angle;
    for (std::size_t i = 1; i < 1000; ++i) {
      const double s = table.column("r_over_R").values[i];
      const double r = s / t;  // at the depth 1
      // The line along the major axis that passes here leaves the axis, or the surface at the distance r0.
      const double r0 = std::max(0.0, (r - std::tan(lean)) / (1.0 - std::tan(lean) * t));
      const double minor = (1.0 - s) * fraction;
      const double difference = rise * (r - r0) * (1.0 + r0 / r) / (2.0 * std::sin(lean));
      EXPECT_NEAR(table.column("hoop").values[i], minor, 1e-9) << angle << ' ' << s;
      EXPECT_NEAR(table.column("normal").values[i], minor + difference * std::cos(lean) * std::cos(lean), 1e-9)
          << angle << ' ' << s;
      EXPECT_NEAR(table.column("shear").values[i], difference * std::sin(lean) * std::cos(lean), 1e-9)
          << angle << ' ' << s;
    }
  }
}

// Numbers of an independent solution, which are good to 1e-3.
TEST(OslCone, AgreesWithAnotherSolution) {
  struct Known {
    const char* hoop;
    double angle, centre, peak, at;
  };
  for (const auto& known : {Known{"radial", 30.0, 0.384, 0.599, 0.370}, Known{"minor", 30.0, 0.500, 0.587, 0.361},
                            Known{"radial", 33.0, 0.342, 0.586, 0.395}, Known{"minor", 33.0, 0.455, 0.572, 0.388}}) {
    const auto table = evaluate(OslCone{.hoop = known.hoop, .angle_deg = known.angle});
    EXPECT_NEAR(table.number("centre_normal"), known.centre, 1e-3);
    EXPECT_NEAR(table.number("peak_normal"), known.peak, 1e-3);
    EXPECT_NEAR(table.number("peak_at"), known.at, 1e-3);
    EXPECT_EQ(table.number("dip"), 1.0);
    EXPECT_NEAR(table.number("dip_depth"), 1.0 - table.number("centre_normal") / table.number("peak_normal"), 1e-15);
  }
}

// The major axis leans by (pi - 2 phi)/4 from the vertical at every point.
TEST(OslCone, FixedPrincipalAxisIsFixed) {
  for (const char* const hoop : {"radial", "minor", "mean"}) {
    for (const double angle : {3.0, 30.0, 36.0}) {
      const auto table = evaluate(OslCone{.hoop = hoop, .angle_deg = angle});
      for (std::size_t i = 1; i < 200; ++i) {
        const double normal = table.column("normal").values[i];
        const double shear = table.column("shear").values[i];
        const double axis = 0.5 * std::atan2(2.0 * shear, normal - table.column("radial").values[i]);
        EXPECT_NEAR(axis, 0.25 * std::numbers::pi - 0.5 * radians(angle), 1e-10) << hoop << angle << ' ' << i;
      }
    }
  }
}

// A surface at the friction angle is at yield. Inside, the radial and the minor hoop stress obey Coulomb's limit, and
// the mean of a fixed axis exceeds it. Margins are exact to 1e-8.
TEST(OslCone, ObeysCoulombsLimitOrReportsIt) {
  for (const auto& cone : cones()) {
    const auto table = evaluate(cone);
    const auto& margin = table.column("yield_margin").values;
    const double least = *std::ranges::min_element(margin);
    EXPECT_NEAR(table.number("yield_margin_min"), least, 2e-3) << title_of(cone);
    if (cone.slope_deg || cone.eta) continue;
    EXPECT_NEAR(margin.back(), 0.0, 1e-8) << title_of(cone);
    if (cone.hoop == "mean") {
      EXPECT_LT(least, -1e-5) << title_of(cone);
    } else if (cone.model != "custom") {
      EXPECT_GE(table.number("yield_margin_min"), 0.0) << title_of(cone);
    }
  }
}

// With a radial hoop stress the sign of mu decides on the dip, as in a wedge. With the minor one a fixed axis dips
// only where 3 sin(phi) > 1: the inner slope of the normal stress is h1 (3 sin(phi) - 1)/cos(phi).
TEST(OslCone, SignOfMuOrTheHoopStressDecidesOnTheDip) {
  for (const double mu : {-1.0, -0.1, 0.1, 0.5}) {
    const auto table = evaluate(OslCone{.model = "custom", .angle_deg = 30.0, .mu = mu});
    EXPECT_EQ(table.number("dip"), mu < 0.0 ? 1.0 : 0.0) << mu;
    EXPECT_EQ(table.number("peak_at") > 0.0, mu < 0.0) << mu;
  }
  const double limit = std::asin(1.0 / 3.0) * degrees_per_radian;
  for (const double off : {-3.0, -0.3, 0.3, 3.0}) {
    EXPECT_EQ(evaluate(OslCone{.hoop = "minor", .angle_deg = limit + off}).number("dip"), off > 0.0 ? 1.0 : 0.0) << off;
  }
}

TEST(OslCone, RefusesClosuresThatAreNotRegularOnTheAxis) {
  EXPECT_TRUE(relations(OslCone{.hoop = "mean"}).empty());
  ASSERT_EQ(relations(OslCone{.model = "bcc", .hoop = "mean"}).size(), 1u);
  EXPECT_NE(relations(OslCone{.model = "bcc", .hoop = "mean"})[0].find("mean needs eta = 1"), std::string::npos);
  const OslCone steep{.model = "custom", .hoop = "minor", .angle_deg = 30.0, .slope_deg = 20.0, .mu = 0.0, .eta = 1.2};
  ASSERT_EQ(relations(steep).size(), 1u);
  EXPECT_NE(relations(steep)[0].find("minor needs eta <= 1"), std::string::npos);
  EXPECT_EQ(relations(OslCone{.slope_deg = 31.0}).size(), 1u);
  EXPECT_EQ(relations(OslCone{.mu = 0.0}).size(), 1u);
  EXPECT_EQ(relations(OslCone{.model = "custom"}).size(), 1u);
  EXPECT_EQ(relations(OslCone{.model = "custom", .mu = 2.0}).size(), 1u);
  EXPECT_EQ(relations(OslCone{.model = "custom", .mu = 2.0, .eta = 1.0}).size(), 1u);
}

// The pressure on the axis of a fixed axis with the mean hoop stress would be negative.
TEST(OslCone, RefusesTensionOnTheAxis) {
  EXPECT_THROW(evaluate(OslCone{.hoop = "mean", .angle_deg = 45.0}), InputError);
  EXPECT_NO_THROW(evaluate(OslCone{.hoop = "mean", .angle_deg = 36.0}));
}

}  // namespace
}  // namespace repose::theory
