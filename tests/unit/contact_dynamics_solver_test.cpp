// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/residual.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"
#include "support/random_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace repose::contact_dynamics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A chain of `count` equal discs of mass 1 on a fixed disc, inclined by `lean` from the vertical. Gravity has given
/// all discs the speed 1 downward.
Problem<2> chain(int count, double lean, double friction, double rolling_friction) {
  Problem<2> problem;
  problem.velocity_scale = 1.0;
  problem.rolling = rolling_friction > 0.0;
  for (int k = 0; k <= count; ++k) {
    Body<2> body;
    body.inverse_mass = k > 0 ? 1.0 : 0.0;
    if (k > 0) body.velocity = {{0.0, -1.0}};
    problem.free.push_back(body);
  }
  for (int k = 1; k <= count; ++k) {
    ContactLine<2> c;
    c.normal = {{std::sin(lean), std::cos(lean)}};
    c.friction = friction;
    c.rolling_friction = rolling_friction;
    c.first = static_cast<std::uint32_t>(k);
    c.second = static_cast<std::uint32_t>(k - 1);
    set_masses(c, 1.0, k > 1 ? 1.0 : 0.0);
    problem.contacts.push_back(c);
  }
  return problem;
}

SolverSettings precise() {
  SolverSettings settings;
  settings.tolerance = 1e-10;
  return settings;
}

// Each contact carries the discs above it. Velocities are accurate to the tolerance of 1e-10. Impulses follow from them
// by two sums over up to 100 contacts, so they are accurate to 100^2 times that.
TEST(ContactDynamicsSolver, StackOf100CarriesWhatLiesAbove) {
  auto problem = chain(100, 0.0, 0.5, 0.0);
  const auto solution = Solver<2>(precise()).solve(problem);
  EXPECT_TRUE(solution.converged);
  EXPECT_LE(residual(problem).worst(), 1e-10);
  for (int k = 0; k < 100; ++k) {
    EXPECT_NEAR(problem.contacts[static_cast<std::size_t>(k)].impulse.normal, 100.0 - k, 1e-6) << k;
  }
}

// A cantilever: at a contact with h discs beyond it, N = h cos, T = h sin, and the torque over the radius is h^2 sin
// (the weights act at odd numbers of radii). Tolerance: residuals of 1e-10 times up to n^4 = 1.6e5.
TEST(ContactDynamicsSolver, LeaningChainOf20IsACantilever) {
  constexpr double lean = 0.5;
  auto problem = chain(20, lean, infinity, infinity);
  const auto solution = Solver<2>(precise()).solve(problem);
  EXPECT_TRUE(solution.converged);
  EXPECT_LE(residual(problem).worst(), 1e-10);
  for (int k = 0; k < 20; ++k) {
    const auto& impulse = problem.contacts[static_cast<std::size_t>(k)].impulse;
    const double beyond = 20.0 - k;
    EXPECT_NEAR(impulse.normal, beyond * std::cos(lean), 2e-5) << k;
    EXPECT_NEAR(std::fabs(impulse.tangent), beyond * std::sin(lean), 2e-5) << k;
    EXPECT_NEAR(std::fabs(impulse.roll), beyond * beyond * std::sin(lean), 2e-5) << k;
  }
}

// Plain sweeps need about n^2 sweeps for a stack, here 6000. That is why the search is accelerated.
TEST(ContactDynamicsSolver, PlainSweepsReportThatTheyReachedTheLimit) {
  auto problem = chain(50, 0.0, 0.5, 0.0);
  SolverSettings settings;
  settings.accelerated = false;
  settings.most_sweeps = 500;
  const auto solution = Solver<2>(settings).solve(problem);
  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(solution.sweeps, 500);
  EXPECT_GT(solution.residual, 1e-3);
  EXPECT_EQ(solution.residual, residual(problem).worst());
  settings.accelerated = true;
  auto again = chain(50, 0.0, 0.5, 0.0);
  const auto fast = Solver<2>(settings).solve(again);
  EXPECT_TRUE(fast.converged);
  EXPECT_LT(fast.sweeps, 60);
}

// The residual detects wrong impulses of every kind, independently of the velocities that the solver left.
TEST(ContactDynamicsSolver, ResidualRejectsPlantedErrors) {
  auto right = chain(5, 0.3, 0.5, 0.5);
  ASSERT_TRUE(Solver<2>(precise()).solve(right).converged);
  EXPECT_LE(residual(right).worst(), 1e-10);
  const auto planted = [&](auto&& spoil) {
    auto problem = right;
    spoil(problem.contacts[2]);
    return residual(problem);
  };
  EXPECT_GT(planted([](auto& c) { c.impulse.normal *= 1.001; }).normal, 1e-4);
  EXPECT_GT(planted([](auto& c) { c.impulse.normal = -1.0; }).normal, 0.1);
  EXPECT_GT(planted([](auto& c) { c.impulse.tangent = 2.0 * c.friction * c.impulse.normal; }).tangential, 0.1);
  EXPECT_GT(planted([](auto& c) { c.impulse.roll = 2.0 * c.rolling_friction * c.impulse.normal; }).rolling, 0.1);
  EXPECT_GT(planted([](auto& c) { c.normal_bias -= 1e-3; }).normal, 1e-4);
  EXPECT_GT(planted([](auto& c) { c.impulse.normal = std::nan(""); }).worst(), 0.1);
}

/// A body of mass 1 that touches a fixed one along the last axis. Without friction it slides at speed 1 along the
/// first.
template <int D>
Problem<D> touching(double friction) {
  Problem<D> problem;
  problem.velocity_scale = 1.0;
  problem.rolling = false;
  problem.free.resize(2);
  problem.free[1].inverse_mass = 1.0;
  problem.free[1].velocity[0] = 1.0;
  ContactLine<D> c;
  c.normal[up<D>] = 1.0;
  c.friction = friction;
  c.first = 1;
  set_masses(c, 1.0, 0.0);
  problem.contacts.push_back(c);
  return problem;
}

// Infinite friction is the limit of high friction: a contact without a normal impulse may slide against friction. An
// impulse of -m_t / 2 leaves half of the slip velocity. Residuals are computed by hand, in units of the slip velocity.
TEST(ContactDynamicsSolver, ResidualKnowsSlidingUnderInfiniteFriction) {
  auto problem = touching<2>(infinity);
  auto& c = problem.contacts[0];
  const double slip = slip_velocity(c, problem.free[1], problem.free[0]);
  c.impulse.tangent = -0.5 * slip * c.tangent_mass;
  EXPECT_NEAR(residual(problem).worst(), 0.0, 1e-15);
  c.friction = 10.0;  // finite friction: none without a normal impulse
  EXPECT_NEAR(residual(problem).worst(), 0.5, 1e-15);
  c.friction = infinity;
  c.impulse.tangent = 0.5 * slip * c.tangent_mass;  // friction along the slip
  EXPECT_NEAR(residual(problem).worst(), 0.5, 1e-15);
  c.impulse.tangent = -0.5 * slip * c.tangent_mass;
  c.normal_bias = 0.2;  // opens
  EXPECT_NEAR(residual(problem).worst(), 0.2, 1e-15);
  c.impulse.tangent = -slip * c.tangent_mass;  // opens, and sticks without a normal impulse
  c.impulse.normal = 1e-200;
  EXPECT_NEAR(residual(problem).worst(), 0.2, 1e-15);
  c.normal_bias = 0.0;
  c.impulse.normal = 0.3;  // pressed, and sticks: right except for the opening velocity that it causes
  EXPECT_NEAR(residual(problem).normal, 0.3, 1e-15);
}

TEST(ContactDynamicsSolver, ResidualOfSlidingSpheresKnowsTheDirection) {
  auto problem = touching<3>(infinity);
  auto& c = problem.contacts[0];
  c.impulse.tangent[0] = -0.5 * c.tangent_mass;
  EXPECT_NEAR(residual(problem).worst(), 0.0, 1e-15);
  c.impulse.tangent[1] = 0.5 * c.tangent_mass;  // slip (0.5, 0.5) is perpendicular to the impulse (-0.5, 0.5)
  EXPECT_NEAR(residual(problem).worst(), std::sqrt(0.5), 1e-15);
}

// An unsolved problem ends with the best impulses found, so more sweeps never give a worse residual. This holds
// exactly, because the residual is computed after every twentieth sweep. With infinite friction the last impulses may
// be worse.
TEST(ContactDynamicsSolver, MoreSweepsAreNeverWorse) {
  for (const bool packed : {false, true}) {
    double before = infinity;
    for (long most = 200; most <= 1000; most += 20) {
      auto problem = random_problem(160, 200, true, 5);
      SolverSettings settings;
      settings.tolerance = 0.0;
      settings.most_sweeps = most;
      settings.packed = packed;
      const auto solution = Solver<2>(settings).solve(problem);
      EXPECT_EQ(solution.residual, residual(problem).worst());
      EXPECT_LE(solution.residual, before) << most;
      before = solution.residual;
    }
    EXPECT_GT(before, 1e-12);
  }
}

TEST(ContactDynamicsSolver, ResidualWithNotANumberIsNotSmall) {
  auto problem = chain(2, 0.0, 0.5, 0.0);
  problem.contacts[0].impulse.normal = std::nan("");
  EXPECT_FALSE(residual(problem).worst() <= 1.0);
}

// A warm start from a solution needs no sweeps.
TEST(ContactDynamicsSolver, SolutionIsLeftAlone) {
  auto problem = chain(20, 0.0, 0.5, 0.0);
  Solver<2> solver(precise());
  ASSERT_TRUE(solver.solve(problem).converged);
  const auto before = problem.contacts;
  const auto solution = solver.solve(problem);
  EXPECT_EQ(solution.sweeps, 0);
  EXPECT_TRUE(solution.converged);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(problem.contacts[k].impulse.normal, before[k].impulse.normal);
  }
}

TEST(ContactDynamicsLaw, WeakeningIsLinearThenConstant) {
  ImpulseLaw law;
  law.friction = 0.4;
  law.dynamic_friction = 0.1;
  EXPECT_EQ(friction_at(law, 3.0), 0.4);
  law.weakening_velocity = 0.02;
  EXPECT_EQ(friction_at(law, 0.0), 0.4);
  EXPECT_NEAR(friction_at(law, -0.01), 0.25, 1e-15);
  EXPECT_EQ(friction_at(law, 0.02), 0.1);
  EXPECT_EQ(friction_at(law, 1.0), 0.1);
}

TEST(ContactDynamicsLaw, InfiniteFrictionCarriesNothingWithoutNormalImpulse) {
  EXPECT_EQ(friction_limit(infinity, 0.0), 0.0);
  EXPECT_EQ(friction_limit(infinity, 1.0), infinity);
  EXPECT_EQ(change_within(0.3, 5.0, infinity), 5.0);
  EXPECT_EQ(change_within(0.3, 5.0, 0.0), -0.3);
}

}  // namespace
}  // namespace repose::contact_dynamics
