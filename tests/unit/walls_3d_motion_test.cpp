// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

// Spheres that move on walls of three dimensions, by the soft method.

#include "support/soft_world.hpp"
#include "support/walls_3d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace repose {
namespace {

using testing::Draws;
using testing::SoftWorld;

constexpr double wall_stiffness = 1e4;
constexpr double depth_at_rest = 1e-4;  // m g / k

SoftSettings<3> on_walls_3d(double time_step, double gravity, std::vector<Wall<3>> walls) {
  SoftSettings<3> settings;
  settings.time_step = time_step;
  settings.gravity = {{0.0, 0.0, -gravity}};
  settings.walls = std::move(walls);
  return settings;
}

// A sphere at rest in a trough hangs on its lowest line, on a round table it stands.
TEST(Walls3dMotion, AtRestOnACylinder) {
  const HookeLinear springs{Hooke{wall_stiffness, 0.5}, Linear{0.5, 5e3, 0.1}};
  SoftWorld<3, HookeLinear> world(springs, on_walls_3d(1e-3, 1.0,
                                                       {frustum_wall({{-3, 0, 0}}, {{3, 0, 0}}, 2.0, 2.0),
                                                        disc_wall({{0, 9, 1}}, {{0, 0, 1}}, 1.0)}));
  const auto inside = world.add({{0.5, 0.0, -1.5}});
  const auto on_table = world.add({{0.3, 9.2, 1.5}});
  world.advance(20000);
  EXPECT_NEAR(world[inside].position[2], -1.5 - depth_at_rest, 1e-9);
  EXPECT_NEAR(world[inside].position[0], 0.5, 1e-12);
  EXPECT_NEAR(world[on_table].position[2], 1.5 - depth_at_rest, 1e-9);
  const auto contacts = world.contacts().list;
  ASSERT_EQ(contacts.size(), 2u);
  for (const auto& contact : contacts) EXPECT_NEAR(contact.normal_force, 1.0, 1e-7);
}

// A sphere that slides over a floor of triangles ends rolling at 5/7 of its speed, and its contact is never broken: the
// friction is mu m g from the first seam to the last before it rolls. The floor is as one without seams.
TEST(Walls3dMotion, SlidingOverSeamsEndsRolling) {
  Draws draws(21);
  std::vector<Wall<3>> floor;
  for (const auto& [a, b, c] : testing::cut_square(draws, 12.0, 99)) floor.push_back(triangle_wall(a, b, c));
  const HookeLinear springs{Hooke{wall_stiffness, 0.5}, Linear{0.3, 5e3, 0.0}};
  SoftWorld<3, HookeLinear> world(springs, on_walls_3d(1e-3, 1.0, floor));
  SoftWorld<3, HookeLinear> plain(springs, on_walls_3d(1e-3, 1.0, {Wall<3>{.point = {}, .normal = {{0, 0, 1}}}}));
  const Vec<3> start{{1.0, 1.3, 0.5 - depth_at_rest}};
  const Vec<3> velocity{{1.2, 1.6, 0.0}};
  const auto grain = world.add(start, velocity);
  const auto twin = plain.add(start, velocity);
  std::vector<std::int64_t> walls;
  for (int k = 0; k < 3500; ++k) {
    world.advance(1);
    plain.advance(1);
    const auto contacts = world.contacts().list;
    ASSERT_EQ(contacts.size(), 1u) << k;
    EXPECT_NEAR(contacts[0].normal_force, 1.0, 1e-6);
    if (walls.empty() || walls.back() != contacts[0].second) walls.push_back(contacts[0].second);
    // It slips until 2 v / 7 mu g = 1.9.
    if (k < 100 || k > 1800) continue;
    EXPECT_NEAR(magnitude(contacts[0].tangential_force), 0.3, 1e-5) << k;
  }
  EXPECT_GT(walls.size(), 7u);
  // The spring of the contact, loaded by mu m g when slip ends, still vibrates with this amplitude of the speed.
  const double vibration = 0.3 / std::sqrt(3.5 * 5e3);
  EXPECT_NEAR(world[grain].velocity[0], 1.2 * 5.0 / 7.0, 1.1 * vibration);
  EXPECT_NEAR(world[grain].velocity[1], 1.6 * 5.0 / 7.0, 1.1 * vibration);
  EXPECT_NEAR(magnitude(Vec<3>(world[grain].position - plain[twin].position)), 0.0, 1e-6);
  EXPECT_NEAR(magnitude(Vec<3>(world[grain].rim_velocity - plain[twin].rim_velocity)), 0.0, 1e-6);
}

// An elastic sphere without friction, let fall into a closed hopper of a cylinder, a cone and two discs, keeps its
// energy and stays inside: each force is the gradient of the depth in one wall.
TEST(Walls3dMotion, EnergyInAHopper) {
  const HookeLinear springs{Hooke{wall_stiffness, 0.0}, Linear{0.0, 5e3, 0.0}};
  const std::vector<Wall<3>> hopper{
      frustum_wall({{0, 0, 0}}, {{0, 0, 4}}, 3.0, 3.0), frustum_wall({{0, 0, -2}}, {{0, 0, 0}}, 1.0, 3.0),
      disc_wall({{0, 0, 4}}, {{0, 0, 1}}, 3.0), disc_wall({{0, 0, -2}}, {{0, 0, 1}}, 1.0)};
  SoftWorld<3, HookeLinear> world(springs, on_walls_3d(2e-4, 1.0, hopper));
  const auto id = world.add({{0.7, -0.4, 2.0}}, {{1.0, 2.0, 0.5}});
  const auto energy = [&] {
    double sum = 0.5 * squared(world[id].velocity) + world[id].position[2];
    for (const auto& contact : world.contacts().list) sum += 0.5 * wall_stiffness * contact.overlap * contact.overlap;
    return sum;
  };
  const double before = energy();
  const double deepest = std::sqrt(2.0 * (before + 1.6) / wall_stiffness);  // all energy in one wall
  int touching = 0;
  for (int k = 0; k < 2000; ++k) {
    world.advance(50);
    touching += world.contacts().list.empty() ? 0 : 1;
    const auto& at = world[id].position;
    ASSERT_LT(std::sqrt(at[0] * at[0] + at[1] * at[1]), 2.5 + deepest);
    ASSERT_GT(at[2], -1.5 - deepest);
    ASSERT_LT(at[2], 3.5 + deepest);
  }
  EXPECT_GT(touching, 20);
  // Leapfrog with w dt = 0.02: relative errors of a collision are about (w dt)^2 / 24.
  EXPECT_NEAR(energy(), before, 0.005 * before);
  EXPECT_EQ(world.method().wall_crossings(world.grains)[0].count, 0);
}

// A drum that turns about its own axis drives a sphere at its bottom, which slips until its rim runs as fast as the
// wall. Nothing resists rolling, so from then on it swings about the bottom, and rolls on the wall.
TEST(Walls3dMotion, ADrumSpinsASphere) {
  const HookeLinear springs{Hooke{wall_stiffness, 0.5}, Linear{0.02, 5e3, 0.1}};
  auto drum = frustum_wall({{0, -3, 0}}, {{0, 3, 0}}, 4.0, 4.0);
  drum.motion.kind = WallMotion<3>::Kind::rotation;
  drum.motion.axis = {{0, 1, 0}};
  drum.motion.speed = 0.1;
  SoftWorld<3, HookeLinear> world(springs, on_walls_3d(1e-3, 10.0, {drum}));
  const auto id = world.add({{0.0, 0.2, -3.5}});
  world.advance(10000);
  double swing = 0.0;
  for (int k = 0; k < 500; ++k) {
    world.advance(20);
    const auto& grain = world[id];
    const Vec<3> outwards = Vec<3>{{grain.position[0], 0.0, grain.position[2]}} * (1.0 / 3.5);
    const Vec<3> rim = grain.velocity + cross(grain.rim_velocity, outwards);
    const Vec<3> wall = cross(Vec<3>{{0.0, 0.1, 0.0}}, outwards * 4.0);
    // Within rounding, the vibration of the spring, and half a step between place and velocity.
    ASSERT_NEAR(magnitude(Vec<3>(rim - wall)), 0.0, 2e-3) << k;
    ASSERT_NEAR(grain.position[1], 0.2, 1e-9);
    ASSERT_NEAR(magnitude(outwards), 1.0, 1e-3);
    swing = std::max(swing, std::fabs(grain.position[0]));
  }
  // The wall speeds it up by less than mu g (1 + 5/2) until it rolls, for at least 0.4 / 0.7 = 0.57: it climbs little.
  EXPECT_GT(swing, 0.01);
  EXPECT_LT(swing, 0.2);
}

}  // namespace
}  // namespace repose
