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

ContactDynamicsSettings<2> tilted(double angle, double time_step, double tolerance = 1e-12) {
  auto settings = rigid_2d(time_step, 1.0, tolerance);
  settings.gravity = Vec<2>{{std::sin(angle), -std::cos(angle)}};
  settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
  return settings;
}

/// The momentum [M L/T], then the angular momentum about the origin [M L^2/T].
std::array<double, 3> momenta(const Grains<2>& grains) {
  std::array<double, 3> sum{};
  for (const auto& g : grains.line) {
    sum[0] += g.mass * g.velocity[0];
    sum[1] += g.mass * g.velocity[1];
    sum[2] += g.mass * (g.position[0] * g.velocity[1] - g.position[1] * g.velocity[0]) +
              0.5 * g.mass * g.radius * g.rim_velocity;
  }
  return sum;
}

// Newton's restitution and the momentum determine both velocities. One contact is solved exactly, to rounding.
TEST(ContactDynamics, TwoBodiesBounceByRestitution) {
  for (const double restitution : {0.0, 0.37, 1.0}) {
    ImpulseLaw law;
    law.restitution = restitution;
    RigidWorld<2> world(law, rigid_2d(0.01, 0.0, 1e-13));
    const auto a = world.add({{0.0, 0.0}}, {{1.0, 0.0}}, 0.0, 0.5);
    const auto b = world.add({{0.8001, 0.0}}, {{-0.5, 0.0}}, 0.0, 0.3);
    world.advance(3);
    const double total = 1.0 * 1.0 - 0.36 * 0.5;
    const double after = restitution * 1.5;
    const double va = (total - 0.36 * after) / 1.36;
    // Without restitution they first touch, at the end of the step.
    EXPECT_NEAR(world[a].velocity[0], va, 1e-12) << restitution;
    EXPECT_NEAR(world[b].velocity[0], va + after, 1e-12) << restitution;
  }
}

TEST(ContactDynamics, SpheresBounceByTheSameText) {
  ImpulseLaw law;
  law.restitution = 0.5;
  law.friction = infinity;
  ContactDynamicsSettings<3> settings;
  settings.time_step = 0.01;
  settings.solver.tolerance = 1e-13;
  RigidWorld<3> world(law, settings);
  const auto a = world.add({{0.0, 0.0, 0.0}}, {{1.0, 0.0, 0.7}});
  const auto b = world.add({{1.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}});
  world.advance(1);
  EXPECT_NEAR(world[a].velocity[0] - world[b].velocity[0], -0.5, 1e-12);
  // Sticking: T = m_t v_t with 1/m_t = 2 (1 + 5/2), and no slip velocity is left.
  EXPECT_NEAR(world[a].velocity[2], 0.7 - 0.7 / 7.0, 1e-12);
  EXPECT_NEAR(world[a].velocity[2] - world[b].velocity[2],
              -(world[a].rim_velocity[1] + world[b].rim_velocity[1]) * -1.0, 1e-12);
}

// vbar_t = v_t+ + e_t v_t- = 0 if |T| <= mu R; otherwise T = mu R against the slip. 1/m_t = 6 for equal discs of
// mass 1.
TEST(ContactDynamics, ObliqueImpactsStickOrSlide) {
  for (const double friction : {0.1, infinity}) {
    ImpulseLaw law;
    law.restitution = 0.5;
    law.tangential_restitution = 0.3;
    law.friction = friction;
    RigidWorld<2> world(law, rigid_2d(0.01, 0.0, 1e-13));
    const auto a = world.add({{0.0, 0.0}}, {{1.0, 0.6}});
    const auto b = world.add({{1.0, 0.0}}, {{0.0, 0.0}});
    world.advance(1);
    const double normal = 0.5 * 1.5;
    const double sticking = 0.6 * 1.3 / 6.0;
    const double tangential = std::min(sticking, friction * normal);
    EXPECT_NEAR(world[a].velocity[1], 0.6 - tangential, 1e-12);
    EXPECT_NEAR(world[b].velocity[1], tangential, 1e-12);
    EXPECT_NEAR(world[a].rim_velocity, -2.0 * tangential, 1e-12);  // I = m r^2 / 2, pushed down on its right side
    EXPECT_NEAR(world[b].rim_velocity, -2.0 * tangential, 1e-12);
    if (friction == infinity) {
      const double slip = world[a].velocity[1] - world[b].velocity[1] + world[a].rim_velocity + world[b].rim_velocity;
      EXPECT_NEAR(slip, -0.3 * 0.6, 1e-12);
    }
  }
}

// Newton's restitution for touching balls gives this result, derived by hand. A real cradle behaves differently; this
// is a property of the law.
TEST(ContactDynamics, TouchingCradle) {
  ImpulseLaw law;
  law.restitution = 1.0;
  RigidWorld<2> world(law, rigid_2d(0.01, 0.0, 1e-13));
  for (int k = 0; k < 5; ++k) world.add({{static_cast<double>(k), 0.0}}, {{k == 0 ? 1.0 : 0.0, 0.0}});
  world.advance(1);
  const std::array<double, 5> expected{-0.6, 0.4, 0.4, 0.4, 0.4};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(world[k].velocity[0], expected[static_cast<std::size_t>(k)], 1e-10) << k;
}

// Velocities are half a step behind the positions, so a free fall has no time-step error.
TEST(ContactDynamics, FreeFallIsExact) {
  RigidWorld<2> world({}, rigid_2d(0.1, 1.0));
  const auto a = world.add({{0.0, 50.0}}, {{0.3, 2.0}});
  world.advance(40);
  EXPECT_NEAR(world[a].position[1], 50.0 + 2.0 * 4.0 - 0.5 * 16.0, 1e-12);
  EXPECT_NEAR(world[a].position[0], 0.3 * 4.0, 1e-12);
}

// The acceleration is g (sin - mu cos) above the friction angle and 0 below. Rolling is prevented.
TEST(ContactDynamics, InclineSlidesAboveTheAngleOfFriction) {
  constexpr double friction = 0.4;
  for (const double excess : {-1e-3, 1e-3}) {
    ImpulseLaw law;
    law.friction = friction;
    law.rolling_friction = infinity;
    const double angle = std::atan(friction) + excess;
    RigidWorld<2> world(law, tilted(angle, 0.01));
    const auto a = world.add({{0.0, 0.5}});
    world.advance(100);
    const double driving = std::sin(angle) - friction * std::cos(angle);
    // Tolerance: 100 steps of residual 1e-12 g dt.
    EXPECT_NEAR(world[a].velocity[0], excess > 0.0 ? driving * 0.01 * 99.5 : 0.0, 1e-12);
    EXPECT_NEAR(world[a].velocity[1], 0.0, 1e-12);
    EXPECT_NEAR(world[a].rim_velocity, 0.0, 1e-12);
  }
}

// A disc that does not slide rolls above theta_r with the acceleration 2/3 g (sin - mu_r cos), and rests below.
TEST(ContactDynamics, InclineRollsAboveTheAngleOfRollingFriction) {
  constexpr double rolling_friction = 0.2;
  for (const double excess : {-1e-3, 1e-3, 0.1}) {
    ImpulseLaw law;
    law.friction = infinity;
    law.rolling_friction = rolling_friction;
    const double angle = std::atan(rolling_friction) + excess;
    RigidWorld<2> world(law, tilted(angle, 0.01));
    const auto a = world.add({{0.0, 0.5}});
    world.advance(100);
    const double driving = std::sin(angle) - rolling_friction * std::cos(angle);
    const double speed = excess > 0.0 ? 2.0 / 3.0 * driving * 0.01 * 99.5 : 0.0;
    // The torque and the friction of a contact are solved alternately, to the solver's tolerance in each of 100 steps.
    EXPECT_NEAR(world[a].velocity[0], speed, 1e-11);
    EXPECT_NEAR(world[a].rim_velocity, -speed, 1e-11);
  }
}

// With infinite coefficients a pressed disc holds on any face, here a vertical one.
TEST(ContactDynamics, InfiniteFrictionHoldsOnAVerticalFaceUnderPressure) {
  ImpulseLaw law;
  law.friction = infinity;
  law.rolling_friction = infinity;
  RigidWorld<2> world(law, tilted(80.0 * degree, 0.05));
  const auto a = world.add({{0.0, 0.5}});
  world.advance(100);
  EXPECT_NEAR(world[a].position[0], 0.0, 1e-12);
}

// A sliding disc ends up rolling at 2/3 of its speed (a sphere: 5/7), for any friction.
TEST(ContactDynamics, SlidingDiscEndsRollingAtTwoThirds) {
  ImpulseLaw law;
  law.friction = 0.3;
  RigidWorld<2> world(law, tilted(0.0, 0.01));
  const auto a = world.add({{0.0, 0.5}}, {{1.0, 0.0}});
  world.advance(300);
  EXPECT_NEAR(world[a].velocity[0], 2.0 / 3.0, 1e-10);
  EXPECT_NEAR(world[a].rim_velocity, -2.0 / 3.0, 1e-10);
}

// A disc in the pocket between two touching fixed discs: each carries m g / (2 cos 30).
TEST(ContactDynamics, PocketSharesTheWeight) {
  RigidWorld<2> world({}, rigid_2d(0.05, 1.0, 1e-12));
  world.add({{-0.5, 0.0}}, {}, 0.0, 0.5, true);
  world.add({{0.5, 0.0}}, {}, 0.0, 0.5, true);
  world.add({{0.0, std::sqrt(0.75)}});
  world.advance(3);
  const auto contacts = world.method.contacts(world.grains);
  ASSERT_EQ(contacts.size(), 2U);
  for (const auto& contact : contacts.list) {
    EXPECT_NEAR(contact.normal_force, 1.0 / (2.0 * std::cos(30.0 * degree)), 1e-10);
    EXPECT_EQ(contact.second, 2);
    EXPECT_LT(contact.normal[1], 0.0);  // from the second to the first
  }
}

// Impulses are equal and opposite and act at one point, so momentum and angular momentum are conserved to rounding,
// converged or not. Seed 11; 60 discs of radius 0.3 to 0.5 that fly together.
TEST(ContactDynamics, MomentaAreConserved) {
  ImpulseLaw law;
  law.restitution = 0.6;
  law.friction = 0.5;
  law.tangential_restitution = 0.2;
  law.rolling_friction = 0.1;
  RigidWorld<2> world(law, rigid_2d(0.02, 0.0));
  for (std::uint64_t k = 0; k < 60; ++k) {
    const auto random = [&](std::uint32_t draw) { return uniform(11, Purpose::release_position, k, draw) - 0.5; };
    const Vec<2> place{{1.1 * static_cast<double>(k % 8) - 3.85, 1.1 * static_cast<double>(k / 8) - 3.85}};
    world.add(place, place * -0.5 + Vec<2>{{random(0), random(1)}}, 4.0 * random(2), 0.4 + 0.2 * random(3));
  }
  const auto before = momenta(world.grains);
  long touched = 0;
  for (int k = 0; k < 200; ++k) {
    ASSERT_FALSE(world.advance(1).trouble);
    touched += static_cast<long>(world.method.contacts(world.grains).size());
  }
  EXPECT_GT(touched, 500);
  const auto after = momenta(world.grains);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-11) << k;
}

// The condition on the gap lets a pair just touch at any speed. Tangential motion past the curve of a disc only opens
// the gap.
TEST(ContactDynamics, NothingOverlapsWhereTheSolverConverges) {
  ImpulseLaw law;
  law.friction = 0.5;
  RigidWorld<2> world(law, [] {
    auto settings = rigid_2d(0.05, 1.0, 1e-7);
    settings.solver.most_sweeps = 20000;
    settings.walls = open_box(6.0);
    return settings;
  }());
  for (int k = 0; k < 20; ++k) {
    const double size = 0.4 + 0.1 * uniform(5, Purpose::grain_size, static_cast<std::uint64_t>(k));
    world.add({{0.6 + 1.17 * (k % 5), 0.6 + 1.1 * (k / 5)}}, {{0.3 * (k % 3), -2.0}}, 0.0, size);
  }
  double deepest = 0.0;
  for (int k = 0; k < 200; ++k) {
    ASSERT_FALSE(world.advance(1).trouble);
    for (const auto& contact : world.method.contacts(world.grains).list) deepest = std::max(deepest, contact.overlap);
  }
  EXPECT_EQ(world.method.account().unconverged, 0);
  // A step leaves an overlap of at most its residual times g dt^2; 200 steps could add up.
  EXPECT_LT(deepest, 200.0 * 1e-7 * 0.05 * 0.05);
}

// An overlap is corrected without a jump: the settled part stays, and a step corrects at most a twentieth of the rest.
TEST(ContactDynamics, OverlapIsCorrectedGradually) {
  auto settings = rigid_2d(0.05, 1.0, 1e-10);
  settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
  RigidWorld<2> world({}, settings);
  const auto a = world.add({{0.0, 0.48}});
  double fastest = 0.0;
  for (int k = 0; k < 200; ++k) {
    world.advance(1);
    fastest = std::max(fastest, world.fastest());
  }
  EXPECT_NEAR(world[a].position[1], 0.5, 1.1e-3 * 0.5);
  EXPECT_LT(fastest, 0.05 * 0.02 / 0.05 + 1e-9);
}

// A grain that moves by most of its radius in a step still meets the next grain.
TEST(ContactDynamics, FastGrainsMeet) {
  ImpulseLaw law;
  law.restitution = 1.0;
  RigidWorld<2> world(law, rigid_2d(0.1, 0.0, 1e-13));
  const auto a = world.add({{0.03, 0.0}}, {{4.5, 0.0}});
  const auto b = world.add({{20.0, 0.0}});
  world.advance(60);
  EXPECT_NEAR(world[a].velocity[0], 0.0, 1e-12);
  EXPECT_NEAR(world[b].velocity[0], 4.5, 1e-12);
}

TEST(ContactDynamics, TooFastIsTrouble) {
  RigidWorld<2> world({}, rigid_2d(0.1, 0.0));
  world.add({{0.0, 0.0}}, {{5.1, 0.0}});
  EXPECT_TRUE(world.advance(10).trouble);
}

// Contacts across the sides of a periodic box are like any other.
TEST(ContactDynamics, PeriodicBoxHasNoSeam) {
  ImpulseLaw law;
  law.restitution = 1.0;
  auto settings = rigid_2d(0.05, 0.0, 1e-13);
  settings.box.periodic = true;
  settings.box.x_min = 0.0;
  settings.box.x_max = 5.0;
  RigidWorld<2> world(law, settings);
  const auto a = world.add({{4.0, 0.0}}, {{1.0, 0.0}});
  const auto b = world.add({{1.0, 0.0}});
  world.advance(40);
  EXPECT_NEAR(world[a].velocity[0], 0.0, 1e-12);
  EXPECT_NEAR(world[b].velocity[0], 1.0, 1e-12);
}

// The impulses on floor and walls equal the weight plus the change of momentum in every step, at rest or not.
TEST(ContactDynamics, BoxCarriesWeightAndMomentum) {
  ImpulseLaw law;
  law.friction = 0.5;
  auto settings = rigid_2d(0.05, 1.0);
  settings.walls = open_box(8.0);
  RigidWorld<2> world(law, settings);
  for (int k = 0; k < 40; ++k) {
    const double size = 0.4 + 0.1 * uniform(9, Purpose::grain_size, static_cast<std::uint64_t>(k));
    world.add({{0.7 + 1.1 * (k % 7), 0.6 + 1.1 * (k / 7)}}, {}, 0.0, size);
  }
  world.advance(1);
  world.method.take_wall_impulses();
  auto before = momenta(world.grains);
  double weight = 0.0;
  for (const auto& grain : world.grains.line) weight += grain.mass;
  for (int k = 0; k < 100; ++k) {
    world.advance(1);
    const auto after = momenta(world.grains);
    const auto taken = world.method.take_wall_impulses();
    const Vec<2> sum = taken[0] + taken[1] + taken[2];
    EXPECT_NEAR(sum[1], -weight * 0.05 - (after[1] - before[1]), 1e-11);
    EXPECT_NEAR(sum[0], -(after[0] - before[0]), 1e-11);
    before = after;
  }
}

// Unconverged solutions creep. A stable leaning chain of 20 must not creep: at the default tolerance the tip moves, in
// 100 steps, by at most the sum that each joint may add, 100 x 20 x 1e-6 g dt^2.
TEST(ContactDynamics, LeaningChainDoesNotCreepAtTheDefaultTolerance) {
  ImpulseLaw law;
  law.friction = infinity;
  law.rolling_friction = infinity;
  RigidWorld<2> world(law, rigid_2d(0.2, 1.0));
  for (int k = 0; k <= 20; ++k) world.add({{k * std::sin(0.5), k * std::cos(0.5)}}, {}, 0.0, 0.5, k == 0);
  world.advance(100);
  EXPECT_EQ(world.method.account().unconverged, 0);
  EXPECT_LT(magnitude(Vec<2>(world[20].position - Vec<2>{{20.0 * std::sin(0.5), 20.0 * std::cos(0.5)}})),
            100.0 * 20.0 * 1e-6 * 0.04);
}

// The same chain collapses under plain sweeps with a limit on their number, and the solver reports it.
TEST(ContactDynamics, UnconvergedChainCreepsAndIsCounted) {
  ImpulseLaw law;
  law.friction = infinity;
  law.rolling_friction = infinity;
  auto settings = rigid_2d(0.2, 1.0);
  settings.solver.accelerated = false;
  settings.solver.most_sweeps = 50;
  RigidWorld<2> world(law, settings);
  for (int k = 0; k <= 20; ++k) world.add({{k * std::sin(0.5), k * std::cos(0.5)}}, {}, 0.0, 0.5, k == 0);
  world.advance(20);
  EXPECT_EQ(world.method.account().unconverged, 20);
  EXPECT_GT(world.method.account().worst_residual, 1e-3);
  EXPECT_LT(world[20].position[1], 20.0 * std::cos(0.5) - 0.1);
}

RigidWorld<2> pouring_box() {
  ImpulseLaw law;
  law.friction = 0.5;
  law.rolling_friction = 0.1;
  auto settings = rigid_2d(0.05, 1.0, 1e-4);
  settings.walls = open_box(8.0);
  RigidWorld<2> world(law, settings);
  for (int k = 0; k < 60; ++k) {
    const double size = 0.4 + 0.1 * uniform(3, Purpose::grain_size, static_cast<std::uint64_t>(k));
    world.add({{0.7 + 1.1 * (k % 7), 0.6 + 1.1 * (k / 7)}}, {{0.2 * (k % 3), 0.0}}, 0.0, size);
  }
  return world;
}

bool same_bits(const Grains<2>& a, const Grains<2>& b) {
  return a.id == b.id && std::memcmp(a.line.data(), b.line.data(), a.size() * sizeof(Grain<2>)) == 0;
}

TEST(ContactDynamics, ResumingContinuesToTheBit) {
  auto whole = pouring_box();
  auto first = pouring_box();
  auto second = pouring_box();
  whole.advance(80);
  first.advance(37);
  testing::MemoryArchive memory;
  first.grains.exchange(memory);
  first.method.exchange(memory);
  memory.restore = true;
  second.grains.exchange(memory);
  second.method.exchange(memory);
  second.advance(43);
  EXPECT_TRUE(same_bits(whole.grains, second.grains));
  EXPECT_FALSE(same_bits(whole.grains, first.grains));
}

// Impulses follow their pair when the grains are reordered in memory: a settled pile that is sorted again needs no
// sweep, only a check of the residual.
TEST(ContactDynamics, WarmStartSurvivesReordering) {
  ImpulseLaw law;
  law.friction = 0.5;
  auto settings = rigid_2d(0.05, 1.0, 1e-9);
  settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
  RigidWorld<2> world(law, settings);
  for (int k = 0; k < 12; ++k) world.add({{0.0, 0.5 + k}});
  world.advance(5);
  world.add({{-3.0, 0.5}});  // sorted before the others in memory
  world.refresh();
  world.advance(1);
  EXPECT_LE(world.method.solution().sweeps, 2);
  EXPECT_TRUE(world.method.solution().converged);
}

TEST(ContactDynamics, SpeedLimitActsBeforeContacts) {
  auto settings = rigid_2d(0.1, 1.0, 1e-12);
  settings.speed_limit = 0.1;
  settings.walls = {plane({{0.0, 0.0}}, {{0.0, 1.0}})};
  RigidWorld<2> world({}, settings);
  const auto a = world.add({{0.0, 1.5}});
  world.advance(5);
  EXPECT_NEAR(world[a].velocity[1], -0.1, 1e-12);
  world.advance(200);
  EXPECT_NEAR(world[a].position[1], 0.5, 1e-9);
}

}  // namespace
}  // namespace repose
