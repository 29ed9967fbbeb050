// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/energy.hpp"

#include "support/every_law.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

// The energy budget closes, and each of its terms is right.

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;
using World = SoftWorld<2, AnyPairLaw>;

AnyPairLaw laws(const NormalLaw& normal, const TangentialLaw& tangential) {
  return any_pair_law({normal, tangential, {}, {}});
}

SoftSettings<2> audited(double time_step, double gravity) {
  auto settings = settings_2d(time_step, gravity);
  settings.audit = true;
  return settings;
}

// A head-on impact: the lost kinetic energy is that dissipated by the dashpot. The leapfrog budget closes exactly
// except for the elastic energy, which is accurate to second order in w dt = 0.014; after separation this error is
// gone.
TEST(Energy, HeadOnImpact) {
  World world(laws(Hooke{1e4, 0.3}, None{}), audited(1e-4, 0.0));
  world.add({{0.0, 0.0}}, {{1.0, 0.0}});
  world.add({{1.1, 0.0}}, {{-1.0, 0.0}});
  double worst = 0.0;
  for (int step = 0; step < 3000; ++step) {
    world.advance(1);
    worst = std::max(worst, std::fabs(world.energy().error()));
  }
  const auto end = world.energy();
  EXPECT_DOUBLE_EQ(end.sources, 1.0);
  EXPECT_NEAR(end.damping, 1.0 - end.kinetic, 2e-5);
  EXPECT_GT(end.damping, 0.3);
  EXPECT_EQ(end.elastic, 0.0);
  EXPECT_EQ(end.friction, 0.0);
  EXPECT_LT(worst, 1e-4);
}

// A disc slides on a wall until it rolls. 2/3 of its speed is left, so friction at the wall has dissipated 1/3 of the
// kinetic energy.
TEST(Energy, SlideToRoll) {
  auto settings = audited(1e-4, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  World world(laws(Hooke{1e4, 0.5}, Linear{0.5, 5e3, 0.1}), settings);
  world.add({{0.0, 0.5 - 1e-4}}, {{3.0, 0.0}});
  world.advance(60000);
  const auto end = world.energy();
  EXPECT_NEAR(end.kinetic, 4.5 * 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(end.walls, 4.5 / 3.0, 1e-3);
  EXPECT_NEAR(end.error(), 0.0, 1e-5);
  EXPECT_EQ(end.damping, 0.0);
}

// A piston compresses a pile against dashpots and friction. The work of its force, minus its own kinetic energy and its
// drag, which are outside the budget, is in the budget. So is the work of a load.
TEST(Energy, PistonAndLoad) {
  auto settings = audited(2e-4, 0.0);
  settings.walls = {
      Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}, Wall<2>{.point = {{0.0, 4.4}}, .normal = {{0.0, -1.0}}},
      Wall<2>{.point = {{-1.1, 0.0}}, .normal = {{1.0, 0.0}}}, Wall<2>{.point = {{1.1, 0.0}}, .normal = {{-1.0, 0.0}}}};
  settings.walls[1].motion = {
      .kind = WallMotion<2>::Kind::force, .direction = {{0.0, -1.0}}, .force = 20.0, .mass = 10.0};
  World world(laws(Hooke{2e4, 0.4}, Linear{0.4, 1e4, 0.2}), settings);
  for (int k = 0; k < 8; ++k) {
    world.add({{k % 2 == 0 ? -0.55 : 0.56, 0.6 + 0.98 * (k / 2) + 0.01 * k}}, {}, 0.0, 0.45 + 0.01 * k);
  }
  world.set_loads({{3, {{1.5, -0.5}}}});
  const auto start = world[3].position;
  world.advance(20000);
  const auto end = world.energy();
  const auto& piston = world.method().walls()[1];
  EXPECT_GT(piston.displacement, 0.2);
  EXPECT_NEAR(end.walls_work, 20.0 * piston.displacement - 0.5 * 10.0 * piston.speed * piston.speed, 2e-3);
  const auto displacement = world[3].position - start;
  EXPECT_NEAR(end.loads_work, 1.5 * displacement[0] - 0.5 * displacement[1], 1e-3);
  EXPECT_GT(end.damping, 0.1);
  EXPECT_GT(end.friction, 0.001);
  EXPECT_NEAR(end.error(), 0.0, 1e-3 * end.put_in());
}

// All combinations of laws, with grains that fall into a box. Energies of the order of 1000 close to a part in a
// thousand: second order of the step in about a thousand impacts. The cumulative law may return more than it stored
// when the normal force changes (docs/physics/soft.md); this counts as friction, not as an error.
TEST(Energy, EveryLawCloses) {
  for (const auto& normal : testing::every_normal_law()) {
    for (const auto& tangential : testing::every_tangential_law()) {
      auto settings = audited(2e-4, 1.0);
      settings.box.periodic = true;
      settings.box.x_min = -4.0;
      settings.box.x_max = 4.0;
      settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
      World world(laws(normal, tangential), settings);
      for (int k = 0; k < 60; ++k) {
        world.add({{-3.6 + 1.2 * (k % 6) + 0.05 * (k % 7), 0.8 + 1.3 * (k / 6)}}, {{0.3 * (k % 5 - 2), 0.0}},
                  0.5 * (k % 3), 0.4 + 0.02 * (k % 6));
      }
      world.advance(40000);
      const auto end = world.energy();
      EXPECT_GT(end.dissipated(), 0.3 * end.sources);
      EXPECT_NEAR(end.error(), 0.0, 1e-3 * end.put_in());
    }
  }
}

// A grain that leaves the box takes its energy along.
TEST(Energy, LostGrains) {
  auto settings = audited(1e-3, 1.0);
  settings.box.floor = -3.0;
  World world(laws(Hooke{1e4, 0.3}, None{}), settings);
  world.add({{0.0, 2.0}}, {{0.5, 0.0}});
  world.add({{5.0, 0.0}}, {{0.0, 40.0}});
  world.advance(4000);
  world.refresh();
  ASSERT_EQ(world.grains.size(), 1U);
  const auto end = world.energy();
  // The first half kick of leapfrog lowers the energy of a fall by (g dt)^2 / 8.
  EXPECT_NEAR(end.lost, 2.0 + 0.125, 1e-6);
  EXPECT_NEAR(end.error(), 0.0, 1e-6);
}

}  // namespace
}  // namespace repose
