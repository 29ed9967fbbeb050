// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "support/hybrid_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace repose {
namespace {

using testing::hybrid_settings;
using testing::HybridWorld;
using testing::level_ground;

double between(std::uint64_t index, std::uint32_t which, double low, double high) {
  return low + (high - low) * uniform(11, Purpose::release_position, index, which);
}

std::array<double, 3> momenta_of(const Grains<2>& grains) {
  std::array<double, 3> sum{};
  for (const auto& g : grains.line) {
    sum[0] += g.mass * g.velocity[0];
    sum[1] += g.mass * g.velocity[1];
    sum[2] += g.mass * (g.position[0] * g.velocity[1] - g.position[1] * g.velocity[0]) +
              0.5 * g.mass * g.radius * g.rim_velocity;
  }
  return sum;
}

// The work of the mean force is the change of elastic energy, whether the bodies touch at both ends of the step, at one
// or at none; the dashpot only takes energy; the derivatives are those of the force.
TEST(HybridSoft, TheMeanForceDoesTheWorkOfTheSpring) {
  const hybrid::Spring spring{1e4, 0.0};
  const hybrid::Spring damped{1e4, 300.0};
  for (std::uint64_t k = 0; k < 10000; ++k) {
    const double before = between(k, 0, -1e-3, 1e-3);
    const double after = between(k, 1, -1e-3, 1e-3);
    const auto mean = hybrid::mean_force(spring, before, after, 0.02);
    const double stored = hybrid::elastic_energy(spring, after) - hybrid::elastic_energy(spring, before);
    EXPECT_NEAR(mean.force * (after - before), stored, 1e-17);  // energies are 5e-3 at most
    const auto force_of = [&](double a, double b) { return hybrid::mean_force(damped, a, b, 0.02).force; };
    EXPECT_GE(force_of(before, after) * (after - before), stored - 1e-17);
    constexpr double h = 1e-8;
    if (std::min({std::fabs(before), std::fabs(after), std::fabs(after - before)}) < 2e-5) continue;
    const auto slope = hybrid::mean_force(damped, before, after, 0.02);
    const double by_after = (force_of(before, after + h) - force_of(before, after - h)) / (2.0 * h);
    const double by_before = (force_of(before + h, after) - force_of(before - h, after)) / (2.0 * h);
    // Differences of forces of 10 to 15 digits over 1e-8.
    EXPECT_NEAR(slope.by_after, by_after, 2e-2);
    EXPECT_NEAR(slope.by_before, by_before, 2e-2);
  }
}

// Two soft discs of different sizes that push each other apart keep momentum, angular momentum and energy. The residual
// of 1e-12 weights in steps of 0.02 leaves 1e-14 a step.
TEST(HybridSoft, AFreePairKeepsMomentaAndEnergy) {
  auto settings = hybrid_settings(1e4);
  settings.gravity = {};
  settings.tolerance = 1e-12;
  HybridWorld world({}, settings);
  world.add({{0.0, 0.0}}, {{0.3, -0.2}}, 0.5);
  world.add({{0.6, 0.5}}, {{-0.1, 0.4}}, 0.3);  // 0.019 deep
  world.start();
  const auto before = momenta_of(world.grains);
  const double energy = world.energy();
  EXPECT_GT(world.method.elastic_energy(world.grains), 0.1);
  EXPECT_FALSE(world.advance(50).trouble);
  const auto after = momenta_of(world.grains);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-12);
  EXPECT_NEAR(world.energy(), energy, 1e-11 * energy);
  EXPECT_EQ(world.method.soft_contacts(), 0U);
  EXPECT_EQ(world.method.take_collision_account().hardened, 1);
}

// Ten layers at rest whose grains are kicked and whose contacts have no dashpots: over a thousand steps the energy
// stays to 1e-9 of it, although contacts on the flanks, which carry nothing, open and close.
TEST(HybridSoft, AnUndampedPileKeepsItsEnergy) {
  auto settings = hybrid_settings(1e4);
  settings.walls = {level_ground()};
  settings.pinned_base = true;
  settings.relaxed_start = true;
  HybridWorld world({}, settings);
  world.add_pile(10);
  world.start();
  ASSERT_FALSE(world.advance(0).trouble);
  constexpr double kick = 1e-3;
  for (std::size_t k = 0; k < world.grains.size(); ++k) {
    world.grains.line[k].velocity = Vec<2>{{k < 10 ? 0.0 : between(k, 0, -kick, kick), between(k, 1, -kick, kick)}};
  }
  const double energy = world.energy();
  double worst = 0.0;
  for (int k = 0; k < 100; ++k) {
    ASSERT_FALSE(world.advance(10).trouble);
    worst = std::max(worst, std::fabs(world.energy() - energy));
  }
  EXPECT_LT(worst, 1e-9 * energy);
  EXPECT_GT(kinetic_energy(world.grains), 1e-6);
  EXPECT_EQ(world.method.take_collision_account().hard, 0);
}

// The same pile, dropped into its own weight: grains leave their contacts, fly, collide without loss and turn soft
// again. Energy is kept to rounding but where a contact turns soft that already overlaps, because the path of a partner
// was corrected: by half the stiffness times the square of some 1e-4 at most.
TEST(HybridSoft, SwitchesBetweenHardAndSoftKeepTheEnergy) {
  auto settings = hybrid_settings(1e4);
  settings.walls = {level_ground()};
  settings.pinned_base = true;
  ImpulseLaw law;
  law.restitution = 1.0;
  HybridWorld world(law, settings);
  world.add_pile(10);
  world.start();
  const double energy = world.energy();
  double worst = 0.0;
  for (int k = 0; k < 50; ++k) {
    ASSERT_FALSE(world.advance(10).trouble);
    worst = std::max(worst, std::fabs(world.energy() - energy));
  }
  const auto account = world.method.take_collision_account();
  EXPECT_LT(worst, 1e-5 * energy);
  EXPECT_GT(account.hard, 20);
  EXPECT_GT(account.softened, 100);
  EXPECT_GT(account.hardened, 100);
}

// A disc on the ground sinks by its weight over the stiffness, and the ground carries the weight.
TEST(HybridSoft, ADiscSinksByItsWeight) {
  auto settings = hybrid_settings(1e4);
  settings.walls = {level_ground()};
  settings.spring.damping = 100.0;
  HybridWorld world({}, settings);
  world.add({{0.0, 0.6}});
  world.start();
  ASSERT_FALSE(world.advance(1000).trouble);
  EXPECT_NEAR(0.5 - world.grains.line[0].position[1], 1e-4, 1e-10);
  const auto contacts = world.method.contacts(world.grains);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts.list[0].second, -1);
  EXPECT_NEAR(contacts.list[0].normal_force, 1.0, 1e-6);
  // The impulse on the ground is the weight times all the time, since the disc began and ended at rest.
  const auto impulses = world.method.take_wall_impulses();
  EXPECT_NEAR(impulses[0][1], -world.method.time(), 1e-6 * world.method.time());
}

// Soft discs on fixed ones: the mean reaction is the weight of what they carry, whatever the sizes.
TEST(HybridSoft, FixedGrainsCarryTheWeight) {
  auto settings = hybrid_settings(1e4);
  settings.relaxed_start = true;
  HybridWorld world({}, settings);
  world.add({{-0.5, 0.0}}, {}, 0.5, true);
  world.add({{0.5, 0.0}}, {}, 0.5, true);
  const double height = std::sqrt(0.8 * 0.8 - 0.25);
  world.add({{0.0, height}}, {}, 0.3);
  world.start();
  ASSERT_FALSE(world.advance(100).trouble);
  double down = 0.0;
  for (const auto& reaction : world.grains.reaction) down -= reaction[1];
  EXPECT_NEAR(down, 0.36 * world.method.time(), 1e-6 * world.method.time());
}

// A disc that slides on the ground with friction in its soft contact ends rolling at two thirds of its speed: the
// friction acts at the rim alone.
TEST(HybridSoft, SlidingFrictionLeadsToRolling) {
  auto settings = hybrid_settings(1e4);
  settings.walls = {level_ground()};
  settings.spring.damping = 100.0;
  settings.slip_drag = 100.0;
  ImpulseLaw law;
  law.rolling_friction = 0.3;
  HybridWorld world(law, settings);
  world.add({{0.0, 0.4999}}, {{1.0, 0.0}});
  world.start();
  ASSERT_FALSE(world.advance(200).trouble);
  EXPECT_NEAR(world.grains.line[0].velocity[0], 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(world.grains.line[0].rim_velocity, -2.0 / 3.0, 1e-6);
}

// Block Gauss-Seidel finds the solution of the direct solver.
TEST(HybridSoft, SweepsAgreeWithTheDirectSolver) {
  Grains<2> found[2];
  for (const bool sweeps : {false, true}) {
    auto settings = hybrid_settings(1e4);
    settings.walls = {level_ground()};
    settings.spring.damping = 100.0;
    settings.static_friction = 0.6;
    settings.slip_drag = 50.0;
    settings.by_sweeps = sweeps;
    settings.tolerance = 1e-10;
    ImpulseLaw law;
    law.rolling_friction = 0.1;
    HybridWorld world(law, settings);
    world.add_pile(5);
    world.start();
    ASSERT_FALSE(world.advance(20).trouble);
    found[sweeps ? 1 : 0] = world.grains;
  }
  for (std::size_t k = 0; k < found[0].size(); ++k) {
    // Twenty steps with residuals of 1e-10 weights move a grain by 1e-12.
    EXPECT_NEAR(found[0].line[k].position[0], found[1].line[k].position[0], 1e-9);
    EXPECT_NEAR(found[0].line[k].position[1], found[1].line[k].position[1], 1e-9);
  }
}

}  // namespace
}  // namespace repose
