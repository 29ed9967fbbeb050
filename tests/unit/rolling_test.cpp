// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Resistance to rolling without a spring, against closed forms. A disc has I = m R^2 / 2, so one that rolls without
// sliding meets 3/2 of its mass.

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;

SoftWorld<2, AnyPairLaw> plane_world(const RollingLaw& rolling, double slope = 0.0) {
  const double angle = std::atan(slope);
  auto settings = settings_2d(2e-4, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{-std::sin(angle), std::cos(angle)}}}};
  return {any_pair_law({Hooke{1e4, 0.5}, Linear{0.8, 5e3, 0.2}, rolling, {}}), settings};
}

// 3/2 m v' = -b m v: v = exp(-2/3 b t). The disc starts with v = R w; its slip spring gives it an error of some
// m g / k_t = 2e-4, and the dashpot uses velocities half a step old, b dt = 1e-4.
TEST(RollingViscous, VelocityDecaysExponentially) {
  auto world = plane_world(RollingViscous{10.0, 0.3});
  const auto disc = world.add({{0.0, 0.5 - 1e-4}}, {{1.0, 0.0}}, -2.0);
  for (const double time : {1.0, 2.0, 4.0}) {
    world.advance(std::lround(time / 2e-4) - std::lround(world.method().time() / 2e-4));
    EXPECT_NEAR(world[disc].velocity[0], std::exp(-2.0 / 3.0 * 0.3 * time), 5e-4);
  }
}

// Below the cap the torque over R is b m_red v_r, above it mu_r N.
TEST(RollingViscous, TorqueIsCapped) {
  const RollingViscous law{0.1, 3.0};
  const auto touch = make_touch(0.99, 1.0 / 0.99, 1.0, 1.0, 0.0, 0.8);
  double nothing = 0.0;
  EXPECT_NEAR(rolling_force(law, touch, {1.0, 1.0}, 0.05, 1e-3, nothing), -3.0 * 0.4 * 0.05, 1e-15);
  EXPECT_EQ(rolling_force(law, touch, {1.0, 1.0}, -7.0, 1e-3, nothing), 0.1);
  EXPECT_EQ(nothing, 0.0);
}

// 3/2 m v' = -mu_r m g above the velocity `full_at`; below it the velocity decays as exp(-2/3 mu_r g t / full_at), here
// to e^-4 after one unit. The tolerance is a few m g / k_t = 2e-4.
TEST(RollingConstant, VelocityFallsLinearly) {
  auto world = plane_world(RollingConstant{0.06, 0.01});
  const auto disc = world.add({{0.0, 0.5 - 1e-4}}, {{1.0, 0.0}}, -2.0);
  world.advance(50000);
  EXPECT_NEAR(world[disc].velocity[0], 1.0 - 2.0 / 3.0 * 0.06 * 10.0, 5e-4);
  world.advance(73750);  // to the time (1 - 0.01) / 0.04 = 24.75, when the velocity is 0.01
  EXPECT_NEAR(world[disc].velocity[0], 0.01, 5e-4);
  world.advance(5000);
  EXPECT_NEAR(world[disc].velocity[0], 0.01 * std::exp(-4.0), 1e-4);
}

// Below the cap spring and dashpot (c = 2 0.3 sqrt(k_r m / 2) = 6) add up. At full mobilisation the torque is the cap
// and no more, and the spring keeps what the dashpot leaves of it.
TEST(RollingSpring, DashpotActsWithinTheCap) {
  const RollingSpring law{0.1, 200.0, 0.3};
  const auto touch = make_touch(0.99, 1.0 / 0.99, 1.0, 1.0, 0.0, 1.0);
  double roll = 2e-4;
  EXPECT_NEAR(rolling_force(law, touch, {1.0, 1.0}, 0.005, 0.0, roll), -0.04 - 0.03, 1e-15);
  EXPECT_EQ(roll, 2e-4);
  EXPECT_EQ(rolling_force(law, touch, {1.0, 1.0}, 0.015, 0.0, roll), -0.1);
  EXPECT_NEAR(roll * 200.0, 0.1 - 0.09, 1e-15);
}

// On a slope below mu_r the disc creeps at the velocity at which the torque balances its weight, full_at tan(angle) /
// mu_r; the approach to it takes 3/2 full_at / mu_r = 0.075. Half of 0.2 here. Above mu_r it accelerates.
TEST(RollingConstant, CreepsOnASlope) {
  auto world = plane_world(RollingConstant{0.2, 0.01}, 0.1);
  const auto disc = world.add({{0.0, 0.5 - 1e-4}});
  world.advance(20000);
  EXPECT_NEAR(magnitude(world[disc].velocity), 0.005, 5e-5);
}

// The dashpots of rolling add to the modes of a bed: neighbours that spin against each other have the rate
// C = 24 c / m with c = b m_red = b / 2, or mu_r N / full_at; without a stiffness the largest step is 2 / C.
TEST(RollingLaws, LargestStepOfABed) {
  const auto largest = [](const RollingLaw& rolling) {
    return largest_step_of_bed({Hooke{100.0, 0.0}, None{}, rolling, {}}, {}, {}, 10.0);
  };
  EXPECT_NEAR(largest(FreeRolling{}), 2.0 / std::sqrt(600.0), 1e-9);
  EXPECT_NEAR(largest(RollingViscous{10.0, 30.0}), 2.0 / (24.0 * 15.0), 1e-9);
  EXPECT_NEAR(largest(RollingConstant{0.1, 0.01}), 2.0 / (24.0 * 100.0), 1e-9);
  EXPECT_NEAR(largest(RollingSpring{0.1, 400.0, 0.0}), 2.0 / std::sqrt(24.0 * 400.0), 1e-9);
}

}  // namespace
}  // namespace repose
