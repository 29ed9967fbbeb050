// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"
#include "support/memory_archive.hpp"
#include "support/rigid_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <string>

namespace repose {
namespace {

using testing::infinity;
using testing::open_box;
using testing::plane;
using testing::rigid_2d;
using testing::RigidWorld;

constexpr double degree = std::numbers::pi / 180.0;

// A wall with a given speed carries a grain along. It does the work m v^2 on it, of which half becomes kinetic energy.
TEST(ContactDynamics, MovingWallPushes) {
  auto settings = rigid_2d(0.01, 0.0, 1e-13);
  auto wall = plane({{0.0, 0.0}}, {{1.0, 0.0}});
  wall.motion.kind = WallMotion<2>::Kind::velocity;
  wall.motion.direction = {{1.0, 0.0}};
  wall.motion.speed = 0.5;
  settings.walls = {wall};
  RigidWorld<2> world({}, settings);
  const auto a = world.add({{1.0, 0.0}});
  world.advance(200);
  EXPECT_NEAR(world[a].velocity[0], 0.5, 1e-12);
  EXPECT_NEAR(world[a].position[0], 0.5 * 2.0 + 0.5, 1e-10);
  EXPECT_NEAR(world.method.walls()[0].displacement, 1.0, 1e-12);
  EXPECT_NEAR(world.method.walls()[0].work, 0.5 * 0.5, 1e-12);
}

/// A floor that moves vertically only.
Wall<2> lift(WallMotion<2>::Kind kind, double mass) {
  auto wall = plane({{0.0, 0.0}}, {{0.0, 1.0}});
  wall.motion.kind = kind;
  wall.motion.direction = {{0.0, 1.0}};
  wall.motion.mass = mass;
  return wall;
}

// A piston of mass 2 under a force of 5 carries a stack of three discs of mass 1. Gravity does not act on the piston,
// so all rise with the acceleration (5 - 3)/(2 + 3). Each contact carries the discs above it times (1 + 0.4).
TEST(ContactDynamics, PistonUnderForceCarriesAStack) {
  auto settings = rigid_2d(0.01, 1.0, 1e-12);
  settings.walls = {lift(WallMotion<2>::Kind::force, 2.0)};
  settings.walls[0].motion.force = 5.0;
  RigidWorld<2> world({}, settings);
  for (int k = 0; k < 3; ++k) world.add({{0.0, 0.5 + k}});
  world.advance(100);
  EXPECT_NEAR(world[2].velocity[1], 0.4 * 0.01 * 99.5, 1e-10);
  EXPECT_NEAR(world.method.walls()[0].speed, 0.4 * 0.01 * 99.5, 1e-10);
  const auto contacts = world.method.contacts(world.grains);
  ASSERT_EQ(contacts.size(), 3U);
  double at_floor = 0.0;
  for (const auto& contact : contacts.list) at_floor = std::max(at_floor, contact.normal_force);
  EXPECT_NEAR(at_floor, 3.0 * 1.4, 1e-8);
}

// At rest the spring carries the weight of the load: 1 mass on a spring of 50 sinks by 1/50. The spring is implicit, so
// the step may be far longer than its period (w dt = 7), and the motion has died out.
TEST(ContactDynamics, PistonOnAStiffSpringComesToRest) {
  auto settings = rigid_2d(1.0, 1.0, 1e-12);
  settings.walls = {lift(WallMotion<2>::Kind::spring, 0.1)};
  settings.walls[0].motion.stiffness = 50.0;
  RigidWorld<2> world({}, settings);
  const auto a = world.add({{0.0, 0.5}});
  world.advance(200);
  EXPECT_NEAR(world.method.walls()[0].displacement, -0.02, 1e-9);
  EXPECT_NEAR(world[a].position[1], 0.48, 1e-9);
}

// Implicit Euler is of first order: the loss of amplitude per period is proportional to the step.
TEST(ContactDynamics, SpringPistonConvergesToItsOscillation) {
  const auto end = [](double step) {
    auto settings = rigid_2d(step, 0.0, 1e-12);
    settings.walls = {lift(WallMotion<2>::Kind::spring, 1.0)};
    settings.walls[0].motion.stiffness = 1.0;
    settings.walls[0].motion.speed = 0.1;
    RigidWorld<2> world({}, settings);
    world.add({{0.0, 50.0}});
    world.advance(std::lround(5.0 / step));
    return world.method.walls()[0].displacement;
  };
  const double exact = 0.1 * (5.0 - std::sin(5.0));
  const double coarse = end(0.02) - exact;
  const double fine = end(0.01) - exact;
  EXPECT_LT(std::fabs(fine), 0.01);
  EXPECT_NEAR(coarse / fine, 2.0, 0.1);
}

// Friction between a disc and a plate that moves along its own plane: only forces along its direction push a piston.
TEST(ContactDynamics, PistonIsDraggedByFriction) {
  ImpulseLaw law;
  law.friction = 0.3;
  law.rolling_friction = infinity;
  auto settings = rigid_2d(0.01, 1.0, 1e-12);
  settings.walls = {lift(WallMotion<2>::Kind::force, 4.0)};
  settings.walls[0].motion.direction = {{1.0, 0.0}};
  RigidWorld<2> world(law, settings);
  const auto a = world.add({{0.0, 0.5}}, {{1.0, 0.0}});
  world.advance(50);
  // Sliding: the disc is decelerated by mu g, the plate accelerated by mu m g / 4.
  EXPECT_NEAR(world[a].velocity[0], 1.0 - 0.3 * 0.01 * 49.5, 1e-9);
  EXPECT_NEAR(world.method.walls()[0].speed, 0.3 * 0.01 * 49.5 / 4.0, 1e-9);
  world.advance(450);
  EXPECT_NEAR(world[a].velocity[0], 0.2, 1e-9);  // sticking: the momentum belongs to the masses 1 and 4 together
  EXPECT_NEAR(world.method.walls()[0].speed, 0.2, 1e-9);
}

}  // namespace
}  // namespace repose
