// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/elasticity.hpp"

#include "repose/laws/impact.hpp"
#include "repose/laws/time_step.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Contacts of elastic materials against the formulas of Hertz and Mindlin. Equalities hold to rounding.

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;

// One material: E* = E / 2 (1 - nu^2), G* = G / 2 (2 - nu), ratio 2 (1 - nu)/(2 - nu).
TEST(Elasticity, OneMaterial) {
  const Elasticity steel{200.0, 0.3};
  EXPECT_NEAR(effective_modulus(steel, steel), 100.0 / 0.91, 1e-12);
  EXPECT_NEAR(effective_shear_modulus(steel, steel), 200.0 / 2.6 / 3.4, 1e-12);
  EXPECT_NEAR(stiffness_ratio(steel, steel), 1.4 / 1.7, 1e-14);
}

// Against a rigid material the compliance is that of the other; the order does not matter.
TEST(Elasticity, TwoMaterials) {
  const Elasticity rubber{2.0, 0.5};
  const Elasticity rigid{1e18, 0.2};
  EXPECT_NEAR(effective_modulus(rubber, rigid), 2.0 / 0.75, 1e-12);
  EXPECT_NEAR(stiffness_ratio(rubber, rigid), 4.0 * (2.0 / (2.0 * 1.5 * 1.5)) / (2.0 / 0.75), 1e-12);
  const Elasticity glass{70.0, 0.22};
  EXPECT_DOUBLE_EQ(stiffness_ratio(rubber, glass), stiffness_ratio(glass, rubber));
  EXPECT_NEAR(1.0 / effective_modulus(rubber, glass), 0.75 / 2.0 + (1.0 - 0.22 * 0.22) / 70.0, 1e-14);
}

// F = 4/3 E* sqrt(R*) overlap^(3/2): spheres of radii 0.3 and 0.6 have R* = 0.2.
TEST(ElasticHertz, ForceDependsOnTheRadii) {
  const ElasticHertz law{1e4, 0.0};
  const auto touch = make_touch(0.89, 1.0 / 0.89, 0.9, 0.9, 0.0, 1.0, 0.5, 0.4);
  const auto force = normal_force(law, touch);
  EXPECT_NEAR(force.elastic, 4.0 / 3.0 * 1e4 * std::sqrt(0.2) * 1e-3, 1e-10);
  EXPECT_NEAR(force.stiffness, 2.0 * 1e4 * std::sqrt(0.2 * 0.01), 1e-9);
  const NormalLaw plain = at_radius(NormalLaw(law), 0.2);
  EXPECT_EQ(normal_force(AnyNormal{plain}, touch).elastic, force.elastic);
}

/// The largest overlap in an impact of this disc at the speed 1 on a fixed disc of radius `other`, or on a wall.
double deepest(double radius, double other) {
  auto settings = settings_2d(2e-5, 0.0);
  if (other == 0.0) settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  SoftWorld<2, AnyPairLaw> world(any_pair_law({ElasticHertz{1e5, 0.0}, None{}, {}, {}}), settings);
  if (other > 0.0) world.add({{0.0, -other}}, {}, 0.0, other, true);
  const auto disc = world.add({{0.0, radius + 1e-3}}, {{0.0, -1.0}}, 0.0, radius);
  double found = 0.0;
  for (int step = 0; step < 10000; ++step) {
    world.advance(1);
    found = std::max(found, radius - world[disc].position[1]);
  }
  return found;
}

// m v^2 / 2 = 2/5 k overlap^(5/2) with k = 4/3 E* sqrt(R*), R* = R on a wall and R R'/(R + R') on a disc. A step moves
// the disc by up to 2e-5, of second order at the deepest point; w dt = 0.005.
TEST(ElasticHertz, ImpactsOnDiscsAndWalls) {
  for (const auto& [radius, other, effective] :
       {std::array{0.5, 0.0, 0.5}, std::array{0.5, 0.5, 0.25}, std::array{0.2, 0.6, 0.15}}) {
    const double stiffness = 4.0 / 3.0 * 1e5 * std::sqrt(effective);
    const double exact = std::pow(0.5 * 4.0 * radius * radius / (0.4 * stiffness), 0.4);
    EXPECT_NEAR(deepest(radius, other) / exact, 1.0, 1e-4) << radius << other;
  }
}

// The stored energy is the integral of the force, for unequal grains too: an undamped impact keeps its account.
TEST(ElasticHertz, EnergyOfUnequalGrains) {
  auto settings = settings_2d(2e-5, 0.0);
  settings.audit = true;
  SoftWorld<2, AnyPairLaw> world(any_pair_law({ElasticHertz{1e5, 0.0}, Mindlin{0.5, 0.8}, {}, {}}), settings);
  world.add({{0.0, 0.0}}, {{1.0, 0.0}}, 0.0, 0.2);
  world.add({{0.8002, 0.0}}, {}, 0.0, 0.6);
  for (int step = 0; step < 3000; ++step) {
    world.advance(1);
    EXPECT_NEAR(world.energy().error(), 0.0, 1e-5);
  }
}

// The fused kernel has the bits of the general one.
TEST(ElasticHertz, FusedKernelHasTheSameBits) {
  const ElasticHertz normal{1e5, 0.2};
  const Mindlin tangential{0.5, 0.8, 0.1};
  const auto run = [](auto& world) {
    world.add({{0.0, 0.0}}, {{1.0, 0.2}}, 1.0, 0.2);
    world.add({{0.8002, 0.1}}, {}, 0.0, 0.6);
    world.add({{0.3, 0.75}}, {{0.0, -1.0}}, -2.0, 0.3);
    world.advance(20000);
  };
  SoftWorld<2, ElasticHertzMindlin> fused({normal, tangential, {}, {}}, settings_2d(2e-5, 0.0));
  SoftWorld<2, AnyPairLaw> general(any_pair_law({normal, tangential, {}, {}}), settings_2d(2e-5, 0.0));
  run(fused);
  run(general);
  for (int id = 0; id < 3; ++id) {
    EXPECT_EQ(fused[id].position, general[id].position);
    EXPECT_EQ(fused[id].rim_velocity, general[id].rim_velocity);
  }
}

// w^2 = k / m at the overlap that a fall reaches; a wall has twice the effective radius of an equal grain.
TEST(ElasticHertz, StiffestContact) {
  const ContactLaws laws{ElasticHertz{1e5, 0.5}, None{}, {}, {}};
  const auto expected = [](double effective) {
    const double k = 4.0 / 3.0 * 1e5 * std::sqrt(effective);
    return std::sqrt(1.5 * k * std::pow(10.0 / (0.4 * k), 0.2));
  };
  EXPECT_NEAR(stiffest_contact(laws, {}, {}, 1.0, 10.0).frequency, expected(0.25), 1e-9);
  EXPECT_NEAR(stiffest_contact(laws, {}, {.flat = true}, 1.0, 10.0).frequency, expected(0.5), 1e-9);
  EXPECT_NEAR(stiffest_contact(laws, {}, {.diameter = 3.0, .mass = 9.0}, 1.0, 10.0).frequency, expected(0.375), 1e-9);
}

}  // namespace
}  // namespace repose
