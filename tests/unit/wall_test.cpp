// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/boundaries/wall.hpp"

#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;
using Kind = WallMotion<2>::Kind;

using Law = PairLaw<Hooke, Linear>;
const Law law{Hooke{1e4, 0.5}, Linear{0.5, 5e3, 0.1}};
constexpr double overlap_at_rest = 1e-4;  // m g / k

Wall<2> segment(double x, double y, double half_length) {
  return {.point = {{x, y}}, .normal = {{0.0, 1.0}}, .half_length = half_length};
}

TEST(Wall, NearestPointOfAFiniteWall) {
  const auto wall = segment(0.0, 0.0, 2.0);
  const auto over = above(wall, wall.normal, {{1.5, 0.7}});
  EXPECT_DOUBLE_EQ(over.height, 0.7);
  EXPECT_EQ(over.normal, (Vec<2>{{0.0, 1.0}}));
  const auto under = above(wall, wall.normal, {{-1.5, -0.7}});
  EXPECT_DOUBLE_EQ(under.height, 0.7);
  EXPECT_EQ(under.normal, (Vec<2>{{0.0, -1.0}}));
  const auto beyond = above(wall, wall.normal, {{2.3, 0.4}});
  EXPECT_NEAR(beyond.height, 0.5, 1e-15);
  EXPECT_NEAR(beyond.normal[0], 0.6, 1e-15);
  EXPECT_NEAR(beyond.normal[1], 0.8, 1e-15);
  // An infinite wall has one side.
  EXPECT_DOUBLE_EQ(above(Wall<2>{}, {{0.0, 1.0}}, {{9.0, -0.3}}).height, -0.3);
}

// Grains rest on the face of a finite wall and, exactly balanced, on its end.
TEST(Wall, CarriesTheWeight) {
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {segment(0.0, 0.0, 2.0)};
  SoftWorld<2, Law> world(law, settings);
  const auto on_face = world.add({{0.5, 0.5}});
  const auto on_end = world.add({{2.0, 0.5}});
  const auto beside = world.add({{3.1, 0.5}});
  world.advance(20000);
  EXPECT_NEAR(world[on_face].position[1], 0.5 - overlap_at_rest, 1e-9);
  EXPECT_NEAR(world[on_end].position[1], 0.5 - overlap_at_rest, 1e-9);
  EXPECT_NEAR(world[beside].position[1], 0.5 - 200.0, 1.0);  // fell for 20
}

// A gate holds a grain until it opens. From that step on the grain is in free fall.
TEST(Wall, GateOpensOnTime) {
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {segment(0.0, 0.0, 5.0)};
  settings.walls[0].opens_at = 3.0;
  SoftWorld<2, Law> world(law, settings);
  const auto grain = world.add({{0.0, 0.5 - overlap_at_rest}});
  world.advance(3000);
  EXPECT_NEAR(world[grain].position[1], 0.5 - overlap_at_rest, 1e-9);
  world.advance(2000);
  // Leapfrog with a constant acceleration: y = -g n (n + 1) dt^2 / 2.
  EXPECT_NEAR(world[grain].position[1] - (0.5 - overlap_at_rest), -0.5 * 2000 * 2001 * 1e-6, 1e-9);
}

// A floor that rises at a given speed carries a grain along at that speed, and carries its weight.
TEST(Wall, PrescribedVelocity) {
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  settings.walls[0].motion = {.kind = Kind::velocity, .direction = {{0.0, 1.0}}, .speed = 0.3, .start = 2.0};
  SoftWorld<2, Law> world(law, settings);
  const auto grain = world.add({{0.0, 0.5 - overlap_at_rest}});
  world.advance(2000);
  EXPECT_EQ(world.method().walls()[0].displacement, 0.0);
  world.advance(18000);
  EXPECT_NEAR(world.method().walls()[0].displacement, 18.0 * 0.3, 1e-9);
  EXPECT_NEAR(world[grain].position[1], 0.5 - overlap_at_rest + 18.0 * 0.3, 1e-8);
  world.take_wall_impulses();
  world.advance(1000);
  const auto impulse = world.take_wall_impulses();
  EXPECT_NEAR(impulse[0][1], -1.0, 1e-8);  // weight 1 for a time 1, downward
  EXPECT_NEAR(impulse[0][0], 0.0, 1e-12);
}

// A belt is a wall that moves along itself with speed V. It drags a disc by friction: v = mu g t while the disc slips.
// The rim of the disc accelerates at 2 mu g in the opposite sense, so slip ends when V = 3 mu g t, and v = V / 3 from
// then on.
TEST(Wall, BeltDragsByFriction) {
  auto settings = settings_2d(1e-4, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}};
  settings.walls[0].motion = {.kind = Kind::velocity, .direction = {{1.0, 0.0}}, .speed = 3.0};
  SoftWorld<2, Law> world(law, settings);
  const auto grain = world.add({{0.0, 0.5 - overlap_at_rest}});
  world.advance(10000);  // time 1: slipping until 3 / (3 mu g) = 2
  EXPECT_NEAR(world[grain].velocity[0], 0.5, 2e-3);
  world.advance(40000);
  EXPECT_NEAR(world[grain].velocity[0], 1.0, 2e-3);
}

// A piston under a given force comes to rest on a grain, which carries that force: overlap F / k on both sides.
TEST(Wall, PistonPressesWithItsForce) {
  auto settings = settings_2d(1e-3, 0.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}},
                    Wall<2>{.point = {{0.0, 1.2}}, .normal = {{0.0, -1.0}}}};
  settings.walls[1].motion = {.kind = Kind::force, .direction = {{0.0, -1.0}}, .force = 7.0, .mass = 5.0, .drag = 2.0};
  SoftWorld<2, Law> world(law, settings);
  const auto grain = world.add({{0.0, 0.5}});
  world.advance(60000);
  EXPECT_NEAR(world[grain].position[1], 0.5 - 7e-4, 1e-9);
  EXPECT_NEAR(world.method().walls()[1].displacement, 0.2 + 2 * 7e-4, 1e-9);
  EXPECT_NEAR(world.method().walls()[1].speed, 0.0, 1e-9);
}

// Without grains the acceleration is F / M. A spring whose far end moves at speed V pulls the piston with the period
// 2 pi sqrt(M / k): x(t) = V (t - sin(w t) / w). Leapfrog at w dt = 0.002 is accurate to four digits.
TEST(Wall, MotionOfAFreePiston) {
  auto settings = settings_2d(1e-3, 0.0);
  settings.walls = {Wall<2>{.point = {{0.0, 50.0}}, .normal = {{0.0, -1.0}}},
                    Wall<2>{.point = {{0.0, -5.0}}, .normal = {{0.0, 1.0}}}};
  settings.walls[0].motion = {.kind = Kind::force, .direction = {{0.0, 1.0}}, .force = 3.0, .mass = 6.0, .start = 1.0};
  settings.walls[1].motion = {
      .kind = Kind::spring, .direction = {{1.0, 0.0}}, .speed = 0.2, .stiffness = 8.0, .mass = 2.0};
  SoftWorld<2, Law> world(law, settings);
  world.add({{0.0, 0.0}});
  world.advance(5000);
  EXPECT_NEAR(world.method().walls()[0].displacement, 0.5 * 0.5 * 16.0, 4e-3);
  EXPECT_NEAR(world.method().walls()[1].displacement, 0.2 * (5.0 - std::sin(10.0) / 2.0), 2e-4);
}

// A wall of another material acts by the law of that pair of materials.
TEST(Wall, Material) {
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}, .material = 1}};
  const Law soft_wall{Hooke{500.0, 0.5}, Linear{0.5, 100.0, 0.1}};
  SoftWorld<2, Law> world(MaterialTable<Law>({law, soft_wall, soft_wall, law}, 2), settings);
  const auto grain = world.add({{0.0, 0.5}});
  world.advance(40000);
  EXPECT_NEAR(world[grain].position[1], 0.5 - 1.0 / 500.0, 1e-9);
}

// A wall may have any slope. Discs slip on it if tan(phi) > 3 mu, with the acceleration g (sin - mu cos).
TEST(Wall, AnySlope) {
  for (const double degrees : {-75.0, -65.0, 60.0, 80.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    auto settings = settings_2d(1e-4, 1.0);
    settings.walls = {Wall<2>{.point = {{3.0, -1.0}}, .normal = {{-std::sin(angle), std::cos(angle)}}}};
    SoftWorld<2, Law> world(law, settings);
    const Vec<2> up_normal = settings.walls[0].normal;
    const auto grain = world.add(settings.walls[0].point + up_normal * (0.5 - overlap_at_rest * std::cos(angle)));
    world.advance(10000);
    const double along = magnitude(world[grain].velocity);
    EXPECT_NEAR(along, std::fabs(std::sin(angle)) - 0.5 * std::cos(angle), 2e-3) << degrees;
  }
}

}  // namespace
}  // namespace repose
