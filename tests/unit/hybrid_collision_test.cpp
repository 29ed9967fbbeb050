// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/random.hpp"
#include "repose/methods/hybrid/collision.hpp"
#include "repose/methods/hybrid/first_touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace repose::hybrid {
namespace {

/// A disc in a collision, with what the conservation laws need.
struct Disc {
  double mass = 1.0;
  double radius = 0.5;
  Vec<2> position{};
  Collider moves;

  double energy() const {
    return 0.5 * mass * (squared(moves.velocity) + squared(moves.rim_velocity) / inverse_inertia_factor<2>);
  }
  /// Momentum, then angular momentum about the origin.
  std::array<double, 3> momenta() const {
    const auto& v = moves.velocity;
    return {mass * v[0], mass * v[1],
            mass * (position[0] * v[1] - position[1] * v[0]) + 0.5 * mass * radius * moves.rim_velocity};
  }
};

double drawn(std::uint64_t pair, std::uint32_t which, double low, double high) {
  return low + (high - low) * uniform(7, Purpose::release_position, pair, which);
}

Disc random_disc(std::uint64_t pair, std::uint32_t first) {
  Disc disc;
  disc.radius = drawn(pair, first, 0.1, 1.0);
  disc.mass = drawn(pair, first + 1, 0.1, 5.0);
  disc.moves.velocity = Vec<2>{{drawn(pair, first + 2, -2.0, 2.0), drawn(pair, first + 3, -2.0, 2.0)}};
  disc.moves.rim_velocity = drawn(pair, first + 4, -2.0, 2.0);
  disc.moves.inverse_mass = 1.0 / disc.mass;
  return disc;
}

// The normal velocity is reversed by the restitution; without slip the surfaces stop against each other, equation (8);
// with slip the impulse lies on the cone of friction; momenta are conserved and energy never rises. All to rounding:
// speeds are about 2 and masses about 5, so 1e-13 is some hundred units in the last place.
TEST(HybridCollision, RandomPairsObeyEveryLaw) {
  int slipped = 0;
  int stuck = 0;
  for (std::uint64_t pair = 0; pair < 20000; ++pair) {
    auto first = random_disc(pair, 0);
    auto second = random_disc(pair, 5);
    const double angle = drawn(pair, 10, 0.0, 2.0 * std::numbers::pi);
    const Vec<2> n{{std::cos(angle), std::sin(angle)}};
    second.position = Vec<2>{{drawn(pair, 11, -3.0, 3.0), drawn(pair, 12, -3.0, 3.0)}};
    first.position = second.position + n * (first.radius + second.radius);
    ImpulseLaw law;
    law.restitution = drawn(pair, 13, 0.0, 1.0);
    law.friction = drawn(pair, 14, 0.0, 1.0);
    if (normal_speed(first.moves, second.moves, n) > 0.0) std::swap(first.moves.velocity, second.moves.velocity);
    const double approach = normal_speed(first.moves, second.moves, n);
    const double energy = first.energy() + second.energy();
    auto before = first.momenta();
    for (int k = 0; k < 3; ++k) before[k] += second.momenta()[k];
    const auto hit = collide(first.moves, second.moves, n, law);
    receive(first.moves, hit, n, 1.0);
    receive(second.moves, hit, n, -1.0);
    (hit.slips ? slipped : stuck) += 1;
    EXPECT_NEAR(normal_speed(first.moves, second.moves, n), -law.restitution * approach, 1e-13);
    if (hit.slips) {
      EXPECT_DOUBLE_EQ(std::fabs(hit.tangential), law.friction * hit.normal);
    } else {
      EXPECT_NEAR(slip_speed(first.moves, second.moves, n), 0.0, 1e-13);
    }
    EXPECT_LE(first.energy() + second.energy(), energy * (1.0 + 1e-14));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(first.momenta()[k] + second.momenta()[k], before[k], 1e-12);
  }
  EXPECT_GT(slipped, 2000);
  EXPECT_GT(stuck, 2000);
}

// A disc that slides along a wall without bouncing leaves it rolling: a third of its speed becomes spin.
TEST(HybridCollision, ASlidingDiscThatSticksRollsAtTwoThirdsOfItsSpeed) {
  Collider disc{{{1.0, -1.0}}, 0.0, 1.0};
  const Vec<2> up{{0.0, 1.0}};
  ImpulseLaw law;
  law.friction = std::numeric_limits<double>::infinity();
  receive(disc, collide(disc, {}, up, law), up, 1.0);
  EXPECT_NEAR(disc.velocity[0], 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(disc.velocity[1], 0.0, 1e-15);
  EXPECT_NEAR(disc.rim_velocity, -2.0 / 3.0, 1e-15);  // clockwise as it moves to the right
}

TEST(HybridCollision, TouchesAreFoundInOrderOfTime) {
  // Head on: a gap of 1 closes at speed 2.
  EXPECT_NEAR(first_touch({{2.0, 0.0}}, {{-2.0, 0.0}}, {}, 1.0, 1.0), 0.5, 1e-15);
  EXPECT_EQ(first_touch({{2.0, 0.0}}, {{2.0, 0.0}}, {}, 1.0, 1.0), no_touch);
  EXPECT_EQ(first_touch({{2.0, 1.1}}, {{-2.0, 0.0}}, {}, 1.0, 1.0), no_touch);  // they pass
  // Touching: at once where they approach, after the throw where gravity brings them back.
  EXPECT_EQ(first_touch({{0.0, 1.0}}, {{0.0, -0.1}}, {}, 1.0, 1.0), 0.0);
  EXPECT_NEAR(first_touch({{0.0, 1.0}}, {{0.0, 0.1}}, {{0.0, -1.0}}, 1.0, 1.0), 0.2, 1e-12);
  EXPECT_EQ(first_touch({{0.0, 1.0}}, {{0.0, 0.1}}, {}, 1.0, 1.0), no_touch);
  // A fall from a height of 1/2 in gravity 1 takes 1.
  EXPECT_NEAR(first_touch({{0.0, 1.5}}, {}, {{0.0, -1.0}}, 1.0, 1.0), 1.0, 1e-12);
}

// Where paths are curved the distance at the touch is the reach, and it is larger before.
TEST(HybridCollision, CurvedPathsTouchAtTheReach) {
  int found = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const double angle = drawn(k, 0, 0.0, 2.0 * std::numbers::pi);
    const Vec<2> apart = Vec<2>{{std::cos(angle), std::sin(angle)}} * drawn(k, 1, 1.0, 1.02);
    const Vec<2> velocity{{drawn(k, 2, -1.0, 1.0), drawn(k, 3, -1.0, 1.0)}};
    const Vec<2> gravity{{0.0, -1.0}};
    const double time = first_touch(apart, velocity, gravity, 1.0, 0.02);
    if (time > 0.02) continue;
    ++found;
    const auto distance = [&](double t) { return magnitude(apart + velocity * t + gravity * (0.5 * t * t)); };
    EXPECT_NEAR(distance(time), 1.0, 1e-12);
    for (int part = 1; part < 10; ++part) EXPECT_GE(distance(0.1 * part * time), 1.0 - 1e-12);
  }
  EXPECT_GT(found, 200);
}

}  // namespace
}  // namespace repose::hybrid
