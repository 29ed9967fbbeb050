// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/instruction_set.hpp"
#include "support/spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

// Small packings of spheres: their motion does not depend on the directions of space, on where a periodic box begins,
// on the number of threads and on the instruction set.

namespace repose {
namespace {

using testing::endless_plane;
using testing::number;
using testing::random_rotation;
using testing::rigid_3d;
using testing::Rotation;
using testing::soft_3d;
using testing::Spheres;

const Vec<3> up{{0.0, 0.0, 1.0}};

/// A box without a lid: a floor and four sides.
std::vector<Wall<3>> open_box(const Rotation& turn) {
  std::vector<Wall<3>> walls{endless_plane({}, turn(up))};
  for (int axis = 0; axis < 2; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Vec<3> inward{};
      inward[axis] = sign;
      walls.push_back(endless_plane(turn(inward * -1.6), turn(inward)));
    }
  }
  return walls;
}

/// Some layers of spheres that fall into each other.
void add_layers(Spheres& world, const Rotation& turn, int layers) {
  for (int k = 0; k < 9 * layers; ++k) {
    const auto draw = static_cast<std::uint32_t>(20 * k);
    const Vec<3> place{{k % 3 - 1.0 + 0.05 * number(3, draw), (k / 3) % 3 - 1.0 + 0.05 * number(3, draw + 1),
                        0.55 + 1.05 * (k / 9) + 0.05 * number(3, draw + 2)}};
    const Vec<3> velocity{{number(3, draw + 3) - 0.5, number(3, draw + 4) - 0.5, -number(3, draw + 5)}};
    const Vec<3> spin{{number(3, draw + 6) - 0.5, number(3, draw + 7) - 0.5, number(3, draw + 8) - 0.5}};
    world.add(turn(place), turn(velocity), turn(spin) * 4.0, 0.45 + 0.05 * number(3, draw + 9));
  }
}

const ContactLaws all_laws{
    Hooke{5e3, 0.5}, Linear{0.4, 1500.0, 0.2}, RollingSpring{0.1, 300.0, 0.3}, {}, TwistingSpring{{0.05, 300.0, 0.3}}};
const ImpulseLaw rigid_law{.friction = 0.4, .rolling_friction = 0.1, .twisting_friction = 0.05};

/// The largest distance between the places, and difference of the velocities, of the spheres of a world and of one that
/// is turned.
double difference(const Spheres& turned, const Spheres& world, const Rotation& turn) {
  double largest = 0.0;
  const auto first = by_id(turned.grains);
  const auto second = by_id(world.grains);
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto& a = turned.grains.line[first[k]];
    const auto& b = world.grains.line[second[k]];
    largest = std::max({largest, magnitude(a.position - turn(b.position)), magnitude(a.velocity - turn(b.velocity)),
                        magnitude(a.rim_velocity - turn(b.rim_velocity))});
  }
  return largest;
}

// Rounding differs, since other numbers are added in another order; collisions amplify it, in these soft ones by some
// hundred. A law that depends on a direction of space would change velocities of 1 by more than a thousandth.
TEST(SpheresPacking, SoftMotionTurnsWithTheWorld) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto run = [&](const Rotation& turn) {
      auto settings = soft_3d(1e-3, turn(-up));
      settings.walls = open_box(turn);
      auto world = std::make_unique<Spheres>(all_laws, settings);
      add_layers(*world, turn, 3);
      EXPECT_FALSE(world->advance(1500).trouble);
      return world;
    };
    const auto turn = random_rotation(seed);
    const auto world = run({});
    EXPECT_GT(world->contacts().size(), 25U);
    EXPECT_LT(difference(*run(turn), *world, turn), 1e-10);
  }
}

// The solver is exact to its tolerance of 1e-11 g dt, and takes the contacts in another order. The impulses of a
// packing are not determined by its motion, so that only places and velocities agree.
TEST(SpheresPacking, RigidMotionTurnsWithTheWorld) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const auto run = [&](const Rotation& turn) {
      auto settings = rigid_3d(5e-3, turn(-up), 1e-11);
      settings.solver.most_sweeps = 20000;
      settings.walls = open_box(turn);
      auto world = std::make_unique<Spheres>(rigid_law, settings);
      add_layers(*world, turn, 2);
      EXPECT_FALSE(world->advance(60).trouble);
      return world;
    };
    const auto turn = random_rotation(seed);
    const auto world = run({});
    EXPECT_GT(world->contacts().size(), 10U);
    EXPECT_LT(difference(*run(turn), *world, turn), 1e-8);
  }
}

/// A bed in a box that is periodic in x and y, 6 by 5, and begins at another place: the bed is shifted.
Spheres periodic_bed(const Vec<3>& shift, const ContactLaws& laws) {
  auto settings = soft_3d(5e-4, -up);
  settings.box.periodic = settings.box.periodic_y = true;
  settings.box.x_min = -1.0;
  settings.box.x_max = 5.0;
  settings.box.y_min = 2.0;
  settings.box.y_max = 7.0;
  settings.skin = 0.1;
  settings.walls = {endless_plane({}, up)};
  Spheres world(laws, settings);
  for (int k = 0; k < 6 * 5 * 3; ++k) {
    const auto draw = static_cast<std::uint32_t>(20 * k);
    const Vec<3> place{{k % 6 + 0.1 * number(5, draw), (k / 6) % 5 + 0.1 * number(5, draw + 1),
                        0.48 + 0.95 * (k / 30) + 0.05 * number(5, draw + 2)}};
    const Vec<3> velocity{{number(5, draw + 3) - 0.5, number(5, draw + 4) - 0.5, 0.0}};
    world.add(settings.box.wrapped(place + shift), velocity, velocity * 2.0, 0.5);
  }
  return world;
}

// A shift by half a length changes places by rounding, 1e-15, and forces by that times the stiffness; a hundred steps
// amplify both tenfold.
TEST(SpheresPacking, APeriodicBoxHasNoPlaceOfItsOwn) {
  for (const auto& laws : {all_laws, ContactLaws{Hooke{5e3, 0.5}, Linear{0.4, 1500.0, 0.2}, {}, {}}}) {
    const auto run = [&](const Vec<3>& shift) {
      auto world = std::make_unique<Spheres>(periodic_bed(shift, laws));
      world->advance(100);
      return world;
    };
    const auto middle = run({});
    const auto forces = middle->contacts();
    ASSERT_GT(forces.size(), 150U);
    for (const auto& shift : {Vec<3>{{0.0, 2.5, 0.0}}, Vec<3>{{3.0, 0.0, 0.0}}, Vec<3>{{3.0, 2.5, 0.0}}}) {
      const auto shifted = run(shift)->contacts();
      ASSERT_EQ(shifted.size(), forces.size());
      for (std::size_t k = 0; k < forces.size(); ++k) {
        ASSERT_EQ(shifted.list[k].first, forces.list[k].first);
        ASSERT_EQ(shifted.list[k].second, forces.list[k].second);
        EXPECT_NEAR(shifted.list[k].normal_force, forces.list[k].normal_force, 1e-9);
        EXPECT_LT(magnitude(shifted.list[k].tangential_force - forces.list[k].tangential_force), 1e-9);
        EXPECT_LT(magnitude(shifted.list[k].rolling - forces.list[k].rolling), 1e-9);
      }
    }
  }
}

std::vector<double> numbers_of(Spheres& world) {
  std::vector<double> numbers;
  for (const auto k : by_id(world.grains)) {
    const auto& grain = world.grains.line[k];
    for (int axis = 0; axis < 3; ++axis) {
      numbers.push_back(grain.position[axis]);
      numbers.push_back(grain.velocity[axis]);
      numbers.push_back(grain.rim_velocity[axis]);
    }
  }
  for (const auto& contact : world.contacts().list) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(contact.tangential_force[axis] + contact.rolling[axis]);
  }
  return numbers;
}

/// Calls use(name) under every instruction set that the machine has.
template <class Use>
void under_every_set(const Use& use) {
  for (const auto set :
       {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has(set)) continue;
    const std::string name(name_of(set));
    ::setenv("REPOSE_INSTRUCTION_SET", name.c_str(), 1);
    use(name);
  }
  ::unsetenv("REPOSE_INSTRUCTION_SET");
}

TEST(SpheresPacking, HasTheSameBitsForThreadsAndInstructionSets) {
  const ContactLaws fused{Hooke{5e3, 0.5}, Linear{0.4, 1500.0, 0.2}, {}, {}};
  for (const auto& laws : {all_laws, fused}) {
    std::vector<double> expected;
    under_every_set([&](const std::string& name) {
      for (const int threads : {1, 2, 4}) {
        auto settings = soft_3d(1e-3, -up);
        settings.walls = open_box({});
        Spheres world(laws, settings, threads);
        add_layers(world, {}, 3);
        world.advance(600);
        const auto numbers = numbers_of(world);
        if (expected.empty()) expected = numbers;
        EXPECT_EQ(numbers, expected) << name << ", " << threads;
      }
    });
    EXPECT_GT(expected.size(), 250U);
  }
  std::vector<double> expected;
  under_every_set([&](const std::string& name) {
    for (const int threads : {1, 2, 4}) {
      auto settings = rigid_3d(5e-3, -up, 1e-6);
      settings.walls = open_box({});
      Spheres world(rigid_law, settings, threads);
      add_layers(world, {}, 3);
      world.advance(40);
      const auto numbers = numbers_of(world);
      if (expected.empty()) expected = numbers;
      EXPECT_EQ(numbers, expected) << name << ", " << threads;
    }
  });
  EXPECT_GT(expected.size(), 250U);
}

}  // namespace
}  // namespace repose
