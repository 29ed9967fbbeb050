// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/equilibrium.hpp"
#include "repose/determinacy/linear_programme.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace repose {
namespace {

constexpr double one_degree = std::numbers::pi / 180.0;

/// Rounding of the simplex method: its tolerance is 1e-9, and the equations of these few contacts magnify it little.
constexpr double simplex_rounding = 1e-8;

/// Discs of weight 1 and radius 1/2 and their contacts, as a test states them.
struct Pile {
  contact_dynamics::Problem<2> problem;
  EquilibriumInput input{problem, {}, {}, 0.0};
  ContactForces recorded;

  std::uint32_t add(bool moves) {
    problem.free.push_back({{}, 0.0, moves ? 1.0 : 0.0});
    input.outer.push_back({{0.0, moves ? -1.0 : 0.0}});
    return static_cast<std::uint32_t>(problem.free.size() - 1);
  }

  /// The normal on `first` leans by `lean` [deg] from the vertical to the right.
  void touch(std::uint32_t first, std::uint32_t second, double lean, double friction, double rolling = 0.0,
             contact_dynamics::Impulse<2> force = {}) {
    contact_dynamics::ContactLine<2> c;
    c.first = first;
    c.second = second;
    c.normal = {{std::sin(lean * one_degree), std::cos(lean * one_degree)}};
    c.friction = friction;
    c.rolling_friction = rolling;
    input.touching.push_back(problem.contacts.size());
    problem.contacts.push_back(c);
    recorded.push_back(force);
  }

  Equilibrium equilibrium() const { return {input, recorded}; }
};

ForceSum normal_of(std::size_t contact) { return {{{contact, 1.0, 0.0}}}; }

TEST(LinearProgramme, FindsExtremesAndSaysWhereThereAreNone) {
  // x + y <= 4, x - y in [-2, 2], x and y >= 0: the corners are (0,0), (2,0), (3,1), (1,3) and (0,2).
  LinearProgramme square({{{{0, 1.0}, {1, 1.0}}}, {{{0, 1.0}, {1, -1.0}}}},
                         {{-LinearProgramme::infinity, 4.0}, {-2.0, 2.0}});
  EXPECT_NEAR(square.most({2.0, 1.0}).value, 7.0, simplex_rounding);
  EXPECT_NEAR(square.least({1.0, -1.0}).value, -2.0, simplex_rounding);
  EXPECT_NEAR(square.most({1.0, 2.0}).x[1], 3.0, simplex_rounding);
  LinearProgramme open({{{{0, 1.0}}}}, {{1.0, LinearProgramme::infinity}});
  EXPECT_EQ(open.most({1.0}).end, LinearProgramme::End::unbounded);
  EXPECT_NEAR(open.least({1.0}).value, 1.0, simplex_rounding);
  LinearProgramme empty({{{{0, 1.0}}}}, {{-LinearProgramme::infinity, -1.0}});
  EXPECT_EQ(empty.least({1.0}).end, LinearProgramme::End::infeasible);
}

TEST(ForceRange, TheFloorUnderADiscBearsItsWeight) {
  Pile pile;
  const auto disc = pile.add(true);
  const auto floor = pile.add(false);
  pile.touch(disc, floor, 0.0, 0.5, 0.0, {1.0, 0.0, 0.0});
  pile.input.margin = 1e-3;
  auto equilibrium = pile.equilibrium();
  EXPECT_EQ(equilibrium.unknowns(), 2U);
  EXPECT_EQ(equilibrium.equations(), 3U);
  EXPECT_NEAR(equilibrium.unbalanced(), 0.0, simplex_rounding);
  const auto down = force_on_body(pile.problem, floor, {{0.0, -1.0}});
  EXPECT_NEAR(equilibrium.least(down).value, 1.0 - 1e-3, simplex_rounding);  // the balance may be missed by the margin
  EXPECT_NEAR(equilibrium.most(down).value, 1.0 + 1e-3, simplex_rounding);
}

TEST(ForceRange, TheRecordedErrorOfABalanceIsAllowed) {
  Pile pile;
  const auto disc = pile.add(true);
  pile.touch(disc, pile.add(false), 0.0, 0.5, 0.0, {1.02, 0.0, 0.0});
  auto equilibrium = pile.equilibrium();
  EXPECT_NEAR(equilibrium.unbalanced(), 0.02, simplex_rounding);
  EXPECT_NEAR(equilibrium.least(normal_of(0)).value, 0.98, simplex_rounding);
  EXPECT_NEAR(equilibrium.most(normal_of(0)).value, 1.02, simplex_rounding);
}

// A disc on two fixed ones, with contacts at an angle a on both sides of the vertical. The torque gives opposite
// frictional forces T and -T, then the balance along x equal normal forces N, and that along y
//   2 N cos a + 2 T sin a = 1.
// With |T| <= mu N: 1 / (2 (cos a + mu sin a)) <= N <= 1 / (2 (cos a - mu sin a)), without an upper bound where
// mu >= cot a, when friction alone can wedge the disc.
TEST(ForceRange, ADiscInAWedgeHasTheRangeOfItsClosedForm) {
  for (const double a : {20.0, 30.0, 60.0}) {
    for (const double mu : {0.0, 0.1, 0.5, 2.0, LinearProgramme::infinity}) {
      Pile pile;
      const auto disc = pile.add(true);
      const double normal = 0.5 / std::cos(a * one_degree);
      pile.touch(disc, pile.add(false), a, mu, 0.0, {normal, 0.0, 0.0});
      pile.touch(disc, pile.add(false), -a, mu, 0.0, {normal, 0.0, 0.0});
      auto equilibrium = pile.equilibrium();
      EXPECT_EQ(equilibrium.unknowns(), mu > 0.0 ? 4U : 2U);
      EXPECT_EQ(equilibrium.equations(), mu > 0.0 ? 3U : 2U);
      const double cosine = std::cos(a * one_degree);
      const double sine = std::sin(a * one_degree);
      for (const std::size_t side : {0U, 1U}) {
        EXPECT_NEAR(equilibrium.least(normal_of(side)).value, 0.5 / (cosine + mu * sine), simplex_rounding)
            << a << " " << mu;
        const auto most = equilibrium.most(normal_of(side));
        if (mu * sine >= cosine) {
          EXPECT_EQ(most.end, LinearProgramme::End::unbounded) << a << " " << mu;
        } else {
          EXPECT_NEAR(most.value, 0.5 / (cosine - mu * sine), simplex_rounding) << a << " " << mu;
        }
      }
      const auto both = equilibrium.least_of_largest({normal_of(0), normal_of(1)});
      EXPECT_NEAR(both.value, 0.5 / (cosine + mu * sine), simplex_rounding) << a << " " << mu;
      EXPECT_NEAR(both.forces[0].normal, both.forces[1].normal, simplex_rounding);
    }
  }
}

// Three discs without friction over three fixed ones at spacing 1.1, so that discs of a row do not touch: six unknowns
// and six equations. Normals lean by asin(0.55). The upper disc presses 1 / (2 cos a) on each lower one, and those
// stand on the outer base discs with 1 / cos a, on the middle one with 1 / (2 cos a).
TEST(ForceRange, ADeterminedPileHasOneState) {
  const double lean = std::asin(0.55) / one_degree;
  const double unit = 1.0 / std::cos(lean * one_degree);
  Pile pile;
  const auto top = pile.add(true);
  const auto left = pile.add(true);
  const auto right = pile.add(true);
  std::vector<std::uint32_t> base;
  for (int k = 0; k < 3; ++k) base.push_back(pile.add(false));
  const std::vector<double> exact{0.5 * unit, 0.5 * unit, unit, 0.5 * unit, 0.5 * unit, unit};
  const auto touch = [&](std::uint32_t first, std::uint32_t second, double side) {
    pile.touch(first, second, side * lean, 0.0, 0.0, {exact[pile.recorded.size()], 0.0, 0.0});
  };
  touch(top, left, 1.0);
  touch(top, right, -1.0);
  touch(left, base[0], 1.0);
  touch(left, base[1], -1.0);
  touch(right, base[1], 1.0);
  touch(right, base[2], -1.0);
  auto equilibrium = pile.equilibrium();
  EXPECT_EQ(equilibrium.unknowns(), equilibrium.equations());
  EXPECT_NEAR(equilibrium.unbalanced(), 0.0, simplex_rounding);
  for (std::size_t k = 0; k < exact.size(); ++k) {
    EXPECT_NEAR(equilibrium.least(normal_of(k)).value, exact[k], simplex_rounding) << k;
    EXPECT_NEAR(equilibrium.most(normal_of(k)).value, exact[k], simplex_rounding) << k;
  }
}

// A disc on a slope of 20 degrees: N = cos 20, T = sin 20, and its torque needs S = T. It rests if the coefficients
// of friction and rolling friction are at least tan 20 = 0.364; below, the least torque that is missed is T - mu_r N.
TEST(ForceRange, TorquesOfRollingFrictionAreFound) {
  const double normal = std::cos(20.0 * one_degree);
  const double tangent = std::sin(20.0 * one_degree);
  for (const double rolling : {0.3, 0.5, LinearProgramme::infinity}) {
    Pile pile;
    const auto disc = pile.add(true);
    pile.touch(disc, pile.add(false), 20.0, 0.6, rolling, {normal, tangent, 0.0});
    auto equilibrium = pile.equilibrium();
    EXPECT_EQ(equilibrium.unknowns(), 3U);
    EXPECT_NEAR(equilibrium.unbalanced(), std::max(0.0, tangent - rolling * normal), simplex_rounding) << rolling;
    EXPECT_NEAR(equilibrium.most(normal_of(0)).value, normal, simplex_rounding) << rolling;
    EXPECT_NEAR(equilibrium.least(normal_of(0)).value, normal, simplex_rounding) << rolling;
  }
}

// Friction of the record above its limit is cut, and what the balance then misses is allowed.
TEST(ForceRange, RecordedForcesAreAmongTheStates) {
  Pile pile;
  const auto disc = pile.add(true);
  pile.touch(disc, pile.add(false), 30.0, 0.5, 0.0, {0.6, -0.4, 0.0});
  pile.touch(disc, pile.add(false), -30.0, 0.5, 0.0, {0.5, 0.1, 0.0});
  auto equilibrium = pile.equilibrium();
  EXPECT_NEAR(equilibrium.recorded()[0].tangent, -0.3, simplex_rounding);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LE(equilibrium.least(normal_of(k)).value, pile.recorded[k].normal + simplex_rounding);
    EXPECT_GE(equilibrium.most(normal_of(k)).value, pile.recorded[k].normal - simplex_rounding);
  }
}

}  // namespace
}  // namespace repose
