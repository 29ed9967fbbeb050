// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/mohr.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose::theory {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// n . sigma . n and t . sigma . n, where t points down the plane to the right and n from its upper to its lower side.
PlaneStress by_rotation(const Mohr& place, double plane_deg) {
  const double t[2] = {std::cos(plane_deg * degree), std::sin(plane_deg * degree)};
  const double n[2] = {-t[1], t[0]};
  const double sigma[2][2] = {{place.s_xx, place.s_xz}, {place.s_xz, place.s_zz}};
  PlaneStress stress;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      stress.normal += n[i] * sigma[i][j] * n[j];
      stress.shear += t[i] * sigma[i][j] * n[j];
    }
  }
  return stress;
}

const Mohr some_places[] = {{.s_xx = 0.4, .s_zz = 1.0, .s_xz = 0.1},   {.s_xx = 1.7, .s_zz = 0.2, .s_xz = -0.5},
                            {.s_xx = -0.3, .s_zz = -1.0, .s_xz = 0.2}, {.s_xx = 0.0, .s_zz = 0.0, .s_xz = 1.0},
                            {.s_xx = 2.0, .s_zz = -2.0, .s_xz = 0.0},  {.s_xx = 1.0, .s_zz = 3.0, .s_xz = 0.0}};

TEST(Mohr, StressOnAPlaneIsTheRotatedTensor) {
  for (const auto& place : some_places) {
    for (double plane = -90.0; plane <= 90.0; plane += 7.5) {
      const auto stress = stress_on_plane(place, plane);
      const auto expected = by_rotation(place, plane);
      EXPECT_NEAR(stress.normal, expected.normal, 2e-15) << plane;
      EXPECT_NEAR(stress.shear, expected.shear, 2e-15) << plane;
      const auto circle = circle_of(place);
      EXPECT_NEAR(std::hypot(stress.normal - circle.centre, stress.shear), circle.radius, 2e-15) << plane;
    }
  }
}

// (11) and (13) as printed, which have no s_xz.
TEST(Mohr, EqualsThePrintedFormsWithoutShear) {
  const Mohr place{.s_xx = 0.3, .s_zz = 1.1, .s_xz = 0.0};
  for (const double alpha : {0.0, 20.0, 45.0, 77.0}) {
    const double c = std::cos(alpha * degree);
    const double s = std::sin(alpha * degree);
    EXPECT_NEAR(stress_on_plane(place, alpha).normal, 0.3 * s * s + 1.1 * c * c, 1e-15);
    EXPECT_NEAR(stress_on_plane(place, alpha).shear, 0.5 * (1.1 - 0.3) * std::sin(2.0 * alpha * degree), 1e-15);
  }
}

// The plane perpendicular to the major stress has no shear, and no plane has a larger normal stress.
TEST(Mohr, PrincipalStresses) {
  for (const auto& place : some_places) {
    const auto circle = circle_of(place);
    EXPECT_GT(circle.principal_angle_deg, -90.0);
    EXPECT_LE(circle.principal_angle_deg, 90.0);
    const auto across = by_rotation(place, -circle.principal_angle_deg);
    EXPECT_NEAR(across.shear, 0.0, 2e-15);
    EXPECT_NEAR(across.normal, circle.major, 2e-15);
    EXPECT_NEAR(by_rotation(place, 90.0 - circle.principal_angle_deg).normal, circle.minor, 2e-15);
    EXPECT_GE(circle.major, circle.minor);
  }
  // The lower end of the major stress points to the right if the upper side of a plane pushes to the right.
  EXPECT_GT(circle_of({.s_xx = 0.4, .s_zz = 1.0, .s_xz = 0.1}).principal_angle_deg, 0.0);
  EXPECT_TRUE(std::isnan(circle_of({.s_xx = 1.0, .s_zz = 1.0, .s_xz = 0.0}).principal_angle_deg));
}

// A minor stress far below the major one. Without shear it equals the given stress. With shear the determinant, the
// product of both, is exactly 2^-40.
TEST(Mohr, SmallPrincipalStressKeepsItsDigits) {
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    for (const double sign : {1.0, -1.0}) {
      const double small = 3e-13 * scale;
      const auto plain = circle_of({.s_xx = sign * small, .s_zz = sign * scale, .s_xz = 0.0});
      EXPECT_NEAR(sign > 0.0 ? plain.minor : -plain.major, small, 1e-15 * small);
      const Mohr sheared{.s_xx = sign * 0.5 * (1.0 + 0x1p-40) * scale, .s_zz = sign * 2.0 * scale, .s_xz = scale};
      const auto circle = circle_of(sheared);
      const double large = (sign > 0.0 ? circle.major : -circle.minor) / scale;
      EXPECT_NEAR(large, 2.5, 1e-11);
      const double other = (sign > 0.0 ? circle.minor : -circle.major) / scale;
      EXPECT_NEAR(other, 0x1p-40 / large, 1e-15 * other);
    }
  }
  // Products that are not exact, with 64 bits: the difference is accurate to 1e-19 / 1e-9, in double alone to 1e-7.
  const Mohr place{.s_xx = 1.1 * 1.1 / 3.0 * (1.0 + 1e-9), .s_zz = 3.0, .s_xz = 1.1};
  const long double determinant =
      static_cast<long double>(place.s_xx) * 3.0L - std::pow(static_cast<long double>(1.1), 2.0L);
  const auto circle = circle_of(place);
  EXPECT_NEAR(circle.minor, static_cast<double>(determinant) / circle.major, 1e-9 * circle.minor);
}

// (15) predicts slip exactly when a search over all planes finds slip on one of them.
TEST(Mohr, RatioIsOneWhereSomePlaneIsAtTheLimit) {
  for (const double phi : {5.0, 30.0, 60.0}) {
    for (const auto& place : some_places) {
      if (place.s_xx + place.s_zz <= 0.0) continue;
      auto here = place;
      here.friction_deg = phi;
      double excess = -std::numeric_limits<double>::infinity();  // the largest |shear| - tan(phi) normal of all planes
      for (int i = 0; i < 180000; ++i) {
        const auto stress = by_rotation(place, i * 1e-3);
        excess = std::max(excess, std::abs(stress.shear) - std::tan(phi * degree) * stress.normal);
      }
      // On the circle it is (R - P sin phi)/cos phi.
      const auto circle = circle_of(place);
      const double held = circle.centre * std::sin(phi * degree);
      EXPECT_NEAR((coulomb_ratio(here) - 1.0) * held, excess * std::cos(phi * degree), 1e-9) << phi;
    }
  }
}

// At the limit the two slip planes, and no other plane, have |shear| = tan(phi) normal, with the stated signs.
TEST(Mohr, SlipPlanesAreAtTheLimit) {
  for (const double turn : {0.0, 20.0, -50.0, 88.0}) {
    const double s = std::sin(34.0 * degree);
    const Mohr place{.s_xx = 1.0 - s * std::cos(2.0 * turn * degree),
                     .s_zz = 1.0 + s * std::cos(2.0 * turn * degree),
                     .s_xz = s * std::sin(2.0 * turn * degree),
                     .friction_deg = 34.0};
    const auto table = evaluate(place);
    EXPECT_NEAR(table.number("principal_angle_deg"), turn, 1e-13);
    EXPECT_NEAR(table.number("coulomb_ratio"), 1.0, 1e-15);
    EXPECT_EQ(table.number("yields"), 0.0);
    const auto first = by_rotation(place, table.number("slip_plane_1_deg"));
    const auto second = by_rotation(place, table.number("slip_plane_2_deg"));
    EXPECT_NEAR(first.shear, std::tan(34.0 * degree) * first.normal, 1e-14);
    EXPECT_NEAR(second.shear, -std::tan(34.0 * degree) * second.normal, 1e-14);
  }
}

// The stress below the flank of a pile at its angle of repose, proportional to (1 + s^2, s c, c^2), slips on the flank.
TEST(Mohr, FlankOfAPileIsASlipPlane) {
  const double s = std::sin(30.0 * degree);
  const double c = std::cos(30.0 * degree);
  const Mohr flank{.s_xx = c * c, .s_zz = 1.0 + s * s, .s_xz = s * c};
  const auto table = evaluate(flank);
  EXPECT_NEAR(table.number("coulomb_ratio"), 1.0, 1e-14);
  EXPECT_NEAR(table.number("slip_plane_1_deg"), 30.0, 1e-13);
}

TEST(Mohr, LimitsOfTheRatio) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(coulomb_ratio({.friction_deg = 0.0}), infinite);
  EXPECT_EQ(coulomb_ratio({.s_xx = 1.0, .s_zz = 1.0, .s_xz = 0.0, .friction_deg = 0.0}), 0.0);
  EXPECT_EQ(coulomb_ratio({.s_xx = 0.0, .s_zz = 0.0, .s_xz = 0.0}), 0.0);
  EXPECT_EQ(coulomb_ratio({.s_xx = -1.0, .s_zz = -1.0, .s_xz = 0.0}), infinite);
  EXPECT_EQ(evaluate({.s_xx = 0.3, .s_zz = 1.0, .s_xz = 0.0}).number("yields"), 1.0);   // 0.7/1.3 > 1/2
  EXPECT_EQ(evaluate({.s_xx = 0.34, .s_zz = 1.0, .s_xz = 0.0}).number("yields"), 0.0);  // 0.66/1.34 < 1/2
}

}  // namespace
}  // namespace repose::theory
