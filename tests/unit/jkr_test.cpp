// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"
#include "support/memory_archive.hpp"
#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Adhesion by Johnson, Kendall and Roberts against its closed forms. Values of the law hold to rounding, about 1e-12.

namespace repose {
namespace {

using testing::MemoryArchive;
using testing::settings_2d;
using testing::SoftWorld;
using World = SoftWorld<2, AnyPairLaw>;

constexpr double w = 0.8;        // surface energy
constexpr double modulus = 3e4;  // E*
constexpr double radius = 0.25;  // R* of two discs of radius 1/2
constexpr double pull = 1.5 * std::numbers::pi * w * radius;
constexpr double hertz = 4.0 / 3.0 * modulus * 0.5;  // stiffness, with the root of R*

const Jkr law{w, modulus};
const JkrContact contact = at_radius(law, radius);

Touch<double> at_overlap(double overlap) {
  const double distance = 1.0 - overlap;
  return make_touch(distance, 1.0 / distance, 1.0, 1.0, 0.0, 1.0);
}

/// The force of the whole contact, positive where it pushes apart.
double force_at(double overlap, bool& bonded) {
  const auto touch = at_overlap(overlap);
  return normal_force(Hertz{hertz, 0.0}, touch).elastic - attraction(law, touch, bonded);
}

// a^3 = 9 pi w R^2 / (2 E) and overlap = a^2 / (3 R) without load.
TEST(Jkr, RestsWithoutLoad) {
  const double a = std::cbrt(9.0 * std::numbers::pi * w * radius * radius / (2.0 * modulus));
  bool bonded = true;
  EXPECT_NEAR(force_at(a * a / (3.0 * radius), bonded), 0.0, 1e-9 * pull);
  EXPECT_NEAR(contact.overlap_under(0.0), a * a / (3.0 * radius), 1e-14);
}

// A contact begins with the pull 4/3 pi w R at zero overlap, and none before; a bonded one reaches 3/2 pi w R where
// a^3 = 9 pi w R^2 / (8 E) and overlap = -a^2 / (3 R), and then ends.
TEST(Jkr, BeginsAndEnds) {
  const double a = std::cbrt(9.0 * std::numbers::pi * w * radius * radius / (8.0 * modulus));
  const double end = -a * a / (3.0 * radius);
  EXPECT_NEAR(contact.overlap_at_pull_off() / end, 1.0, 1e-12);
  bool bonded = false;
  EXPECT_EQ(force_at(0.5 * end, bonded), 0.0);
  EXPECT_FALSE(bonded);
  EXPECT_NEAR(force_at(1e-15, bonded), -4.0 / 3.0 * std::numbers::pi * w * radius, 1e-6 * pull);
  EXPECT_TRUE(bonded);
  EXPECT_NEAR(force_at(end * (1.0 - 1e-9), bonded), -pull, 1e-9 * pull);
  EXPECT_TRUE(bonded);
  EXPECT_EQ(force_at(end * (1.0 + 1e-9), bonded), 0.0);
  EXPECT_FALSE(bonded);
}

// The overlap of the root found is the one wanted, from pull-off to overlaps at which adhesion does not count; the
// force is the derivative of the energy, and the stiffness that of the force (central differences).
TEST(Jkr, RootEnergyAndStiffness) {
  const double end = contact.overlap_at_pull_off();
  for (const double overlap : {end, 0.5 * end, -1e-12, 0.0, 1e-9, -end, -10.0 * end, -1000.0 * end, 0.3}) {
    EXPECT_NEAR(contact.overlap(contact.root_of(overlap)), overlap, 1e-14) << overlap;
  }
  for (const double overlap : {0.7 * end, -0.5 * end, -5.0 * end, -300.0 * end}) {
    const double h = -1e-4 * end;
    const auto energy = [](double at) { return contact.energy(contact.root_of(at)); };
    const auto force = [](double at) { return contact.force(contact.root_of(at)); };
    EXPECT_NEAR((energy(overlap + h) - energy(overlap - h)) / (2.0 * h), force(overlap), 1e-5 * pull);
    EXPECT_NEAR((force(overlap + h) - force(overlap - h)) / (2.0 * h) / contact.stiffness(contact.root_of(overlap)),
                1.0, 1e-5);
  }
}

// At a load P the contact area is that of Hertz under P + 3 pi w R + sqrt(6 pi w R P + (3 pi w R)^2).
TEST(Jkr, ApparentLoad) {
  const double load = 4.0;
  const double p = 2.0 * pull;
  EXPECT_NEAR(contact.apparent_load(load), load + p + std::sqrt(2.0 * p * load + p * p), 1e-12);
  bool bonded = true;
  EXPECT_NEAR(force_at(contact.overlap_under(load), bonded), load, 1e-9);
}

// A stiffness k of Hertz's law means E* = 3 k / (4 sqrt(R*)).
TEST(Jkr, ModulusOfAStiffness) {
  const auto by_stiffness = at_radius(Jkr{w, 0.0, hertz}, radius);
  EXPECT_NEAR(by_stiffness.modulus, modulus, 1e-9);
}

SoftSettings<2> settings_of(double time_step, bool audit) {
  auto settings = settings_2d(time_step, 0.0);
  settings.audit = audit;
  return settings;
}

/// Two discs that approach each other at this relative speed, almost in touch.
struct TwoDiscs : World {
  TwoDiscs(double speed, double time_step, bool audit = false)
      : World(any_pair_law({ElasticHertz{modulus, 0.0}, None{}, {}, law}), settings_of(time_step, audit)) {
    add({{0.0, 0.0}}, {{0.5 * speed, 0.0}});
    add({{1.001, 0.0}}, {{-0.5 * speed, 0.0}});
  }
};

/// 3.503 (w^5 R^4 / E^2)^(1/3): the closed form of `energy_of_break`.
double lost_in_a_cycle() {
  const double part = 0.3 - 0.2 * std::pow(0.75, 4.0 / 3.0);
  return part * std::cbrt(std::pow(2.0 * std::numbers::pi * w, 5.0) * std::pow(radius, 4.0) / (modulus * modulus));
}

// Two undamped discs meet and part: the energy 3.503 (w^5 R^4/E^2)^(1/3) is lost where the bond ends. The contact
// begins with a jump of the force, which a step may see late by up to v dt: up to 4/3 pi w R v dt = 2 % of that energy.
TEST(Jkr, EnergyLostInACycle) {
  EXPECT_NEAR(lost_in_a_cycle() / energy_of_break(law, at_overlap(0.0)), 1.0, 1e-9);
  EXPECT_NEAR(lost_in_a_cycle() / std::cbrt(std::pow(w, 5.0) * std::pow(radius, 4.0) / (modulus * modulus)), 3.503,
              1e-3);
  const double speed = 0.4;
  TwoDiscs world(speed, 2e-6, true);
  world.advance(60000);
  const double left = world[1].velocity[0] - world[0].velocity[0];
  ASSERT_GT(left, 0.0);
  const double lost = 0.25 * (speed * speed - left * left);
  EXPECT_NEAR(lost / lost_in_a_cycle(), 1.0, 0.03);
  EXPECT_TRUE(world.contacts().list.empty());
  const auto energy = world.energy();
  EXPECT_NEAR(energy.damping, lost_in_a_cycle(), 1e-12);
  EXPECT_NEAR(energy.error(), 0.0, 0.03 * lost_in_a_cycle());
}

// Slower than that they stay bonded, and stretch beyond touching without parting.
TEST(Jkr, SlowDiscsStick) {
  const double speed = 0.9 * std::sqrt(4.0 * lost_in_a_cycle());
  TwoDiscs world(speed, 1e-5);
  double longest = 0.0;
  for (int step = 0; step < 20000; ++step) {
    world.advance(1);
    longest = std::max(longest, world[1].position[0] - world[0].position[0] - 1.0);
    if (step > 5000) {
      ASSERT_EQ(world.contacts().list.size(), 1U);
    }
  }
  EXPECT_LT(longest, 1.001 * 1e-3);
}

// A disc hangs on a wall or a fixed disc up to a load of 3/2 pi w R, where R is its radius for a wall.
TEST(Jkr, PullOff) {
  for (const bool wall : {false, true}) {
    const double hold = wall ? 2.0 * pull : pull;
    for (const double part : {0.98, 1.02}) {
      auto settings = settings_2d(1e-4, part * hold);
      if (wall) settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, -1.0}}}};
      World world(any_pair_law({ElasticHertz{modulus, 0.3}, None{}, {}, law}), settings);
      if (!wall) world.add({{0.0, 0.5}}, {}, 0.0, 0.5, true);
      const double effective = wall ? 0.5 : radius;
      const auto at_pull_off = at_radius(law, effective).overlap_at_pull_off();
      const auto disc = world.add({{0.0, -0.5 + 1e-9}});
      world.set_loads({{disc, {{0.0, part * hold}}}});
      world.advance(10000);
      // The load falls away slowly, so that the disc does not swing.
      for (int step = 0; step < 1000; ++step) {
        world.set_loads({{disc, {{0.0, part * hold * (1.0 - step / 1000.0)}}}});
        world.advance(20);
      }
      world.set_loads({});
      world.advance(10000);
      const double gap = -0.5 - world[disc].position[1];
      if (part < 1.0) {
        EXPECT_GT(gap, 0.0) << wall;
        EXPECT_LT(gap, -at_pull_off) << wall;
      } else {
        EXPECT_GT(gap, 0.1) << wall;
      }
    }
  }
}

// The bond of a stretched contact is kept by a checkpoint: a run that continues from one has the bits of one that does
// not. The disc swings below a fixed one; its weight is 0.94 of the pull-off force.
TEST(Jkr, Checkpoint) {
  const auto make = [] {
    return make_kernel<2, AnyPairLaw>(
        MaterialTable<AnyPairLaw>(any_pair_law({ElasticHertz{modulus, 0.1}, None{}, {}, law})),
        settings_2d(1e-4, 0.94 * pull));
  };
  Team team(1);
  Grains<2> grains;
  for (int k = 0; k < 2; ++k) {
    Grain<2> grain;
    grain.position = {{0.0, -0.99999 * k}};
    grain.radius = 0.5;
    grain.mass = 1.0;
    grain.inverse_mass = k;
    grains.add(grain, k);
  }
  auto straight = make();
  straight->grains_added(grains);
  const auto overlap = [](const Method<2>& method, const Grains<2>& of) {
    return method.contacts(of).list.at(0).overlap;
  };
  double time = 0.0;
  do {
    time += 0.001;
    straight->advance(grains, time, team);
  } while (overlap(*straight, grains) > 0.3 * contact.overlap_at_pull_off() && time < 2.0);
  ASSERT_LT(time, 2.0);
  MemoryArchive archive;
  grains.exchange(archive);
  straight->exchange(archive);
  Grains<2> copy;
  auto resumed = make();
  archive.restore = true;
  copy.exchange(archive);
  resumed->exchange(archive);
  resumed->restored(copy, team);
  straight->advance(grains, 3.0, team);
  resumed->advance(copy, 3.0, team);
  for (std::size_t k = 0; k < grains.size(); ++k) EXPECT_EQ(grains.line[k].position, copy.line[k].position);
  EXPECT_EQ(overlap(*resumed, copy), overlap(*straight, grains));
}

// The time step knows the stiffness where a fall ends: that of Hertz's law for a weak adhesion, more for a strong one.
TEST(Jkr, StiffestContact) {
  const auto frequency = [](const CohesionLaw& cohesion) {
    return stiffest_contact({ElasticHertz{modulus, 0.0}, None{}, {}, cohesion}, {}, {}, 1.0, 1.0).frequency;
  };
  EXPECT_NEAR(frequency(Jkr{1e-9, modulus}) / frequency(NoCohesion{}), 1.0, 1e-6);
  EXPECT_GT(frequency(Jkr{3.0, modulus}), 1.005 * frequency(NoCohesion{}));
}

}  // namespace
}  // namespace repose
