// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/hybrid_world.hpp"
#include "support/memory_archive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace repose {
namespace {

using testing::hybrid_settings;
using testing::HybridWorld;
using testing::level_ground;

ImpulseLaw bouncy(double restitution) {
  ImpulseLaw law;
  law.restitution = restitution;
  law.friction = 0.3;
  law.rolling_friction = 0.1;
  return law;
}

HybridSettings on_ground() {
  auto settings = hybrid_settings(1e4);
  settings.walls = {level_ground()};
  settings.spring.damping = 100.0;
  settings.slip_drag = 100.0;
  settings.static_friction = 0.5;
  return settings;
}

/// Discs in rows above the ground, the rows shifted so that they do not stand on each other.
void add_rain(HybridWorld& world, int count, int of_row) {
  for (int k = 0; k < count; ++k) {
    const double shift = 0.13 * static_cast<double>((k / of_row) % 3);
    world.add({{1.2 * (k % of_row) + shift, 1.0 + 1.1 * static_cast<double>(k / of_row)}});
  }
}

bool same_bits(const Grains<2>& a, const Grains<2>& b) {
  return a.size() == b.size() && std::memcmp(a.line.data(), b.line.data(), a.size() * sizeof(Grain<2>)) == 0;
}

// Flights and bounces are exact: after a fall by 1 and a bounce at restitution 1/2, a quarter of the energy is left.
TEST(Hybrid, ABounceLeavesTheSquareOfTheRestitution) {
  auto settings = on_ground();
  HybridWorld world(bouncy(0.5), settings);
  world.add({{0.0, 1.5}});
  world.start();
  ASSERT_FALSE(world.advance(100).trouble);  // the first bounce is at 1.414, the second at 2.83
  const auto& disc = world.grains.line[0];
  EXPECT_NEAR(disc.position[1] - 0.5 + 0.5 * disc.velocity[1] * disc.velocity[1], 0.25, 1e-12);
  const double after = 2.0 - std::sqrt(2.0);  // since the bounce, upwards at sqrt(2)/2
  EXPECT_NEAR(disc.position[1], 0.5 + 0.5 * std::sqrt(2.0) * after - 0.5 * after * after, 1e-12);
  const auto account = world.method.take_collision_account();
  EXPECT_EQ(account.hard, 1);
  EXPECT_EQ(account.softened, 0);
}

// A bounce whose flight would end within the step turns the contact soft, rule (22): parting at less than g dt = 0.02.
TEST(Hybrid, AContactTurnsSoftWhereItWouldCloseWithinTheStep) {
  for (const double parting : {0.019, 0.021}) {
    HybridWorld world(bouncy(0.5), on_ground());
    const double speed = 2.0 * parting;
    world.add({{0.0, 0.5 + 1e-6}}, {{0.0, -std::sqrt(speed * speed - 2e-6)}});
    world.start();
    ASSERT_FALSE(world.advance(1).trouble);
    const auto account = world.method.take_collision_account();
    EXPECT_EQ(account.hard, 1);
    EXPECT_EQ(account.softened, parting < 0.02 ? 1 : 0) << parting;
  }
}

// A soft contact ends where the discs are apart and part: the disc then flies without it.
TEST(Hybrid, ASoftContactEndsWhereTheDiscsPart) {
  auto settings = on_ground();
  settings.spring.damping = 0.0;
  HybridWorld world(bouncy(0.5), settings);
  world.add({{0.0, 0.49}});  // holds 0.5 of energy
  world.start();
  EXPECT_EQ(world.method.soft_contacts(), 1U);
  const double energy = world.energy();
  ASSERT_FALSE(world.advance(20).trouble);
  EXPECT_EQ(world.method.soft_contacts(), 0U);
  EXPECT_NEAR(world.energy(), energy, 1e-10);
  EXPECT_EQ(world.method.take_collision_account().hardened, 1);
}

// Many bouncing discs come to rest: no cascade of collisions holds the run up, and energy never rises.
TEST(Hybrid, ABouncyRainComesToRest) {
  auto settings = on_ground();
  settings.slip_drag = 0.0;
  for (const double x : {-1.0, 10.5}) {
    Wall<2> side;
    side.point = Vec<2>{{x, 0.0}};
    side.normal = Vec<2>{{x < 0.0 ? 1.0 : -1.0, 0.0}};
    settings.walls.push_back(side);
  }
  HybridWorld world(bouncy(0.9), settings);
  add_rain(world, 200, 9);
  world.start();
  double energy = world.energy();
  double rise = 0.0;
  for (int k = 0; k < 300; ++k) {
    ASSERT_FALSE(world.advance(1).trouble) << world.method.trouble(world.grains);
    rise = std::max(rise, world.energy() - energy);
    energy = world.energy();
  }
  // A rise by half the stiffness times the square of an overlap of 1e-4 is allowed for (see hybrid_soft_test).
  EXPECT_LT(rise, 1e-3);
  const auto account = world.method.take_collision_account();
  EXPECT_GT(account.hard, 1000);
  EXPECT_GT(account.softened, 100);
  EXPECT_GT(account.hardened, 100);
  double impulse = 0.0;
  for (const auto& grain : world.grains.line) impulse += grain.mass * grain.velocity[1];
  // Ground and sides have taken what gravity gave.
  double taken = 0.0;
  for (const auto& of_wall : world.method.take_wall_impulses()) taken -= of_wall[1];
  EXPECT_NEAR(taken, 200.0 * world.method.time() + impulse, 1e-4 * 200.0 * world.method.time());
}

// The division of a run into advances changes no bit, nor does a checkpoint.
TEST(Hybrid, PiecesAndCheckpointsChangeNoBit) {
  HybridWorld whole(bouncy(0.5), on_ground());
  add_rain(whole, 24, 4);
  whole.start();
  ASSERT_FALSE(whole.advance(400).trouble);

  HybridWorld pieces(bouncy(0.5), on_ground());
  add_rain(pieces, 24, 4);
  pieces.start();
  for (const long steps : {1L, 70L, 229L}) ASSERT_FALSE(pieces.advance(steps).trouble);
  testing::MemoryArchive archive;
  pieces.grains.exchange(archive);
  pieces.method.exchange(archive);
  HybridWorld resumed(bouncy(0.5), on_ground());
  archive.restore = true;
  resumed.grains.exchange(archive);
  resumed.method.exchange(archive);
  Team alone(1);
  resumed.method.restored(resumed.grains, alone);
  ASSERT_FALSE(resumed.advance(100).trouble);
  ASSERT_FALSE(pieces.advance(100).trouble);
  EXPECT_TRUE(same_bits(whole.grains, pieces.grains));
  EXPECT_TRUE(same_bits(whole.grains, resumed.grains));
  EXPECT_GT(whole.method.soft_contacts(), 5U);
}

// Grains that are added later land on those that rest and roll off them, and grains that leave the box are forgotten.
TEST(Hybrid, GrainsComeAndGo) {
  auto settings = on_ground();
  settings.box.x_min = -2.0;
  settings.box.x_max = 20.0;
  HybridWorld world(bouncy(0.2), settings);
  world.add({{0.0, 0.5}});
  world.start();
  ASSERT_FALSE(world.advance(50).trouble);
  world.add({{0.001, 2.0}});
  world.start();
  world.add({{-1.5, 0.6}}, {{-2.0, 0.0}});
  world.start();
  ASSERT_FALSE(world.advance(100).trouble);
  Team alone(1);
  world.method.refresh(world.grains, alone);
  EXPECT_EQ(world.grains.size(), 2U);
  ASSERT_FALSE(world.advance(500).trouble);
  EXPECT_NEAR(world.grains.line[1].position[1], 0.5, 1e-3);
}

}  // namespace
}  // namespace repose
