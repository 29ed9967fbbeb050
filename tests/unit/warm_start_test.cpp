// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/rigid_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace repose {
namespace {

using testing::plane;
using testing::rigid_2d;
using testing::RigidWorld;

constexpr double wedge_friction = 0.5;
constexpr double wedge_step = 0.1;
constexpr double wedge_cosine = 0.86602540378443865;  // of 30 degrees
constexpr double wedge_sine = 0.5;

/// The state with the least normal forces that balances the weight 1 of a disc between two fixed ones: see the wedge of
/// tests/unit/force_range_test.cpp.
constexpr double least_normal = 0.5 / (wedge_cosine + wedge_friction * wedge_sine);

/// The normal forces on the left and right fixed disc after a step from that state, or from nothing. `speed` is that of
/// the disc before the step, along x.
std::array<double, 2> forces_after_step(WarmStart warm_start, bool from_state, double speed = 0.0) {
  auto settings = rigid_2d(wedge_step, 1.0, 1e-12);
  settings.warm_start = warm_start;
  RigidWorld<2> world(ImpulseLaw{.friction = wedge_friction}, settings);
  world.add({{-0.5, 0.0}}, {}, 0.0, 0.5, true);
  world.add({{0.5, 0.0}}, {}, 0.0, 0.5, true);
  world.add({{0.0, wedge_cosine}}, {{speed, 0.0}});
  world.refresh();
  if (from_state) {
    Contacts<2> contacts;
    for (const std::int64_t side : {0, 1}) {
      Contact<2> contact;
      contact.first = side;
      contact.second = 2;
      contact.normal_force = least_normal;
      contact.tangential_force = (side == 0 ? 1.0 : -1.0) * wedge_friction * least_normal;
      contacts.list.push_back(contact);
    }
    world.method.set_slip_displacements(world.grains, contacts);
  }
  world.advance(1);
  const auto contacts = world.method.contacts(world.grains);
  EXPECT_EQ(contacts.size(), 2U);
  return {contacts.list.at(0).normal_force, contacts.list.at(1).normal_force};
}

constexpr double wedge_rounding = 1e-9;  // tolerance of the solver: 1e-12 g dt

TEST(WarmStart, KeepsOrDropsTheStateOfTheStepBefore) {
  const auto cold = forces_after_step(WarmStart::always, false);
  EXPECT_GT(cold[0], least_normal + 0.01);  // another of the states that statics allows
  for (const auto warm_start : {WarmStart::always, WarmStart::settled}) {
    for (const double normal : forces_after_step(warm_start, true)) EXPECT_NEAR(normal, least_normal, wedge_rounding);
  }
  for (const double normal : forces_after_step(WarmStart::never, true)) EXPECT_NEAR(normal, cold[0], wedge_rounding);
}

TEST(WarmStart, SettledGrainsAreSlowerThanATenthOfTheFallInAStep) {
  for (const double speed : {0.09 * wedge_step, 0.11 * wedge_step}) {
    const auto like = speed < 0.1 * wedge_step ? WarmStart::always : WarmStart::never;
    const auto expected = forces_after_step(like, true, speed);
    const auto found = forces_after_step(WarmStart::settled, true, speed);
    for (std::size_t side = 0; side < 2; ++side) EXPECT_NEAR(found[side], expected[side], wedge_rounding) << speed;
  }
}

// The forces of a packing from another run are an equally good start.
TEST(WarmStart, ForcesOfAnotherRunAreAnEquallyGoodStart) {
  const auto stack = [] {
    auto settings = rigid_2d(0.05, 1.0, 1e-9);
    settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
    RigidWorld<2> world({}, settings);
    for (int k = 0; k < 12; ++k) world.add({{0.0, 0.5 + k}});
    return world;
  };
  auto first = stack();
  first.advance(5);
  const auto contacts = first.method.contacts(first.grains);
  ASSERT_EQ(contacts.size(), 12U);
  auto second = stack();
  second.refresh();
  second.method.set_slip_displacements(second.grains, contacts);
  second.advance(1);
  EXPECT_EQ(second.method.solution().sweeps, 0);
  const auto after = second.method.contacts(second.grains);
  ASSERT_EQ(after.size(), contacts.size());
  for (std::size_t k = 0; k < after.size(); ++k) {
    EXPECT_NEAR(after.list[k].normal_force, contacts.list[k].normal_force, 1e-12);
  }
}

}  // namespace
}  // namespace repose
