// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

// With velocities at the time of the force, positions, velocities and displacements of contacts are of second order in
// the step, friction and rolling resistance included. The result at one time for steps of dt, dt/2 and dt/4 shows the
// order: the ratio of the two differences is 4 for second order and 2 for first.

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;
using World = SoftWorld<2, AnyPairLaw>;

/// Three numbers of the end state.
using State = std::array<double, 3>;

template <class StateAfter>
std::array<double, 3> ratios(const StateAfter& state_after, double step) {
  const State coarse = state_after(step);
  const State middle = state_after(0.5 * step);
  const State fine = state_after(0.25 * step);
  std::array<double, 3> found{};
  for (std::size_t k = 0; k < 3; ++k) found[k] = (coarse[k] - middle[k]) / (middle[k] - fine[k]);
  return found;
}

SoftSettings<2> synchronised(double step, double gravity, const Vec<2>& wall_normal) {
  auto settings = settings_2d(step, gravity);
  settings.synchronised = true;
  settings.walls = {Wall<2>{.point = {}, .normal = wall_normal}};
  return settings;
}

constexpr double impact_step = 5e-5;

/// An impact on a floor without damping at the speeds 0.3 and -1, k = 1e4, k_t = 5e3, from 82 1/3 steps before until
/// the time of the largest overlap, after 360 steps. Contact begins a third or two thirds of a step after a step,
/// whatever the step, and both have the same error.
State oblique_impact(double step, double friction, const TangentialLaw& law) {
  TangentialLaw tangential = law;
  std::visit(
      [&](auto& one) {
        if constexpr (requires { one.friction; }) one.friction = friction;
      },
      tangential);
  World world(any_pair_law({Hooke{1e4, 0.0}, tangential, {}, {}}), synchronised(step, 0.0, {{0.0, 1.0}}));
  const auto disc = world.add({{0.0, 0.5 + impact_step * 247.0 / 3.0}}, {{0.3, -1.0}});
  world.advance(std::lround(360.0 * impact_step / step));
  return {world[disc].position[1], world[disc].velocity[0], world[disc].rim_velocity};
}

// All of the path sticks. The next order is visible, and the partial cancellation of two errors: both leave 10 % at
// this step and go with it.
TEST(Synchronised, StickingImpactIsOfSecondOrder) {
  const auto found = ratios([](double dt) { return oblique_impact(dt, 10.0, Linear{0.0, 5e3, 0.0}); }, impact_step);
  for (const double ratio : found) EXPECT_NEAR(ratio, 4.0, 0.3);
}

// A friction of 0.05 is overcome from the start, since k_t v_t / k v_n = 0.15, and until the end: it takes 0.15 off the
// slip velocity of 0.3.
TEST(Synchronised, SlidingImpactIsOfSecondOrder) {
  const auto found = ratios([](double dt) { return oblique_impact(dt, 0.05, Linear{0.0, 5e3, 0.0}); }, impact_step);
  for (const double ratio : found) EXPECT_NEAR(ratio, 4.0, 0.3);
}

/// A disc on a slope of 0.2 falls from zero overlap; k_t is so soft that it sways, held by friction, and the dashpots
/// act.
State on_a_slope(double step, const RollingLaw& rolling, const TangentialLaw& tangential) {
  const double angle = std::atan(0.2);
  const Vec<2> normal{{-std::sin(angle), std::cos(angle)}};
  World world(any_pair_law({Hooke{2e3, 0.1}, tangential, rolling, {}}), synchronised(step, 1.0, normal));
  const auto disc = world.add(normal * 0.4998);
  world.advance(std::lround(0.256 / step));
  return {dot(world[disc].position, normal), world.contacts().list.at(0).slip, world[disc].rim_velocity};
}

// The contact starts at an overlap of 2e-4 and stays closed, so the motion is smooth. The tolerance is the next order,
// w dt = 0.05.
TEST(Synchronised, FrictionOnASlopeIsOfSecondOrder) {
  for (const RollingLaw& rolling : {RollingLaw(FreeRolling{}), RollingLaw(RollingSpring{0.5, 300.0, 0.2})}) {
    const auto found = ratios([&](double dt) { return on_a_slope(dt, rolling, Linear{5.0, 900.0, 0.1}); }, 1e-3);
    for (const double ratio : found) EXPECT_NEAR(ratio, 4.0, 0.3);
  }
}

// The energy budget closes with synchronised velocities too: an oblique impact with dashpots and friction, whose
// elastic energy is zero after it. The error is that of the integration, of second order in w dt = 0.014.
TEST(Synchronised, EnergyBudgetCloses) {
  auto settings = synchronised(1e-4, 1.0, {{0.0, 1.0}});
  settings.audit = true;
  World world(any_pair_law({Hooke{1e4, 0.3}, Linear{0.3, 5e3, 0.2}, {}, {}}), settings);
  world.add({{0.0, 0.7}}, {{1.0, -0.5}});
  world.add({{0.3, 1.9}}, {{0.0, -1.0}});
  world.advance(8000);
  const auto end = world.energy();
  EXPECT_GT(end.dissipated(), 0.2);
  EXPECT_NEAR(end.error(), 0.0, 1e-3 * end.put_in());
}

}  // namespace
}  // namespace repose
