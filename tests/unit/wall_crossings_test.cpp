// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/wall_crossings.hpp"

#include "support/walls_3d.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace repose {
namespace {

Grains<2> grain_at(Vec<2> place) {
  Grains<2> grains;
  Grain<2> grain;
  grain.position = place;
  grain.radius = 0.5;
  grain.inverse_mass = 1.0;
  grains.add(grain, 7);
  return grains;
}

/// What a wall from (-1, 0) to (1, 0) notices of a grain that goes from place to place.
Crossings noticed(const std::vector<Vec<2>>& places, const Box<2>& box = {}) {
  const std::vector<Wall<2>> walls{{.normal = {{0.0, 1.0}}, .half_length = 1.0}};
  const std::vector<WallNow<2>> now{wall_now(walls[0], {}, 0.0)};
  WallCrossings<2> crossings(1);
  for (std::size_t k = 0; k < places.size(); ++k) {
    crossings.check(grain_at(places[k]), walls, now, box, static_cast<double>(k));
  }
  return crossings.until(grain_at(places.back()), walls, now, box, 99.0)[0];
}

TEST(WallCrossings, ThroughTheWallAndBack) {
  const auto once = noticed({{{0.0, 0.3}}, {{0.1, 0.1}}, {{0.2, -0.1}}, {{0.2, -0.3}}});
  EXPECT_EQ(once.count, 1);
  EXPECT_EQ(once.first, 7);
  EXPECT_EQ(once.time, 2.0);
  EXPECT_EQ(noticed({{{0.0, 0.3}}, {{0.0, -0.3}}, {{0.0, 0.3}}}).count, 2);
}

TEST(WallCrossings, RoundTheEndIsNoCrossing) {
  std::vector<Vec<2>> places;
  for (int k = -8; k <= 8; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / 8.0;
    places.push_back({{1.0 + 0.5 * std::cos(angle), 0.5 * std::sin(angle)}});
  }
  EXPECT_EQ(noticed(places).count, 0);
}

TEST(WallCrossings, ThroughTheSideOfAPeriodicBox) {
  Box<2> box;
  box.periodic = true;
  box.x_min = -5.5;
  box.x_max = 0.5;  // the wall ends at x = -5 beyond the side
  EXPECT_EQ(noticed({{{-5.4, 0.1}}, {{-5.4, -0.1}}}, box).count, 1);
  EXPECT_EQ(noticed({{{-4.9, 0.1}}, {{-4.9, -0.1}}}, box).count, 0);
}

// A grain at rest, past which a wall turns by 90 degrees about the origin; and one that the wall leaves on its side.
TEST(WallCrossings, AWallThatTurns) {
  Wall<2> wall{.point = {{1.0, 0.0}}, .normal = {{0.0, 1.0}}, .half_length = 0.5};
  wall.motion.kind = WallMotion<2>::Kind::rotation;
  wall.motion.axis = 1.0;
  const auto count = [&](Vec<2> place) {
    WallCrossings<2> crossings(1);
    for (int k = 0; k <= 10; ++k) {
      const std::vector<WallNow<2>> now{wall_now(wall, {.displacement = 0.05 * std::numbers::pi * k}, 0.0)};
      crossings.check(grain_at(place), {wall}, now, {}, k);
      if (k == 10) return crossings.until(grain_at(place), {wall}, now, {}, k)[0].count;
    }
    return std::int64_t{-1};
  };
  EXPECT_EQ(count({{0.7, 0.7}}), 1);
  EXPECT_EQ(count({{0.3, 0.3}}), 0);   // within the inner end of the wall
  EXPECT_EQ(count({{0.7, -0.7}}), 0);  // behind it
}

/// How often a sphere that goes straight from one place to another in `steps` goes through a wall of three dimensions.
std::int64_t crossings_in_3d(const Wall<3>& wall, const Vec<3>& from, const Vec<3>& to, int steps) {
  WallCrossings<3> crossings(1);
  Grains<3> grains;
  Grain<3> grain;
  grain.radius = 0.5;
  grain.inverse_mass = 1.0;
  grains.add(grain, 7);
  const std::vector<WallNow<3>> now{wall_now(wall, {}, 0.0)};
  for (int k = 0; k <= steps; ++k) {
    grains.line[0].position = from + (to - from) * (static_cast<double>(k) / steps);
    crossings.check(grains, {wall}, now, {}, k);
  }
  return crossings.until(grains, {wall}, now, {}, 99.0)[0].count;
}

// In small steps a sphere crosses once wherever the sign of its height changes at a place of the wall; a cylinder or a
// cone that it passes right through counts twice.
TEST(WallCrossings, ShapesOfThreeDimensions) {
  const auto rectangle = rectangle_wall({{0, 0, 0}}, {{2, 0, 0}}, {{0, 4, 0}});
  EXPECT_EQ(crossings_in_3d(rectangle, {{1.9, 3.9, 0.5}}, {{1.9, 3.9, -0.5}}, 7), 1);
  EXPECT_EQ(crossings_in_3d(rectangle, {{2.1, 3.9, 0.5}}, {{2.1, 3.9, -0.5}}, 7), 0);
  EXPECT_EQ(crossings_in_3d(rectangle, {{1.9, 4.1, 0.5}}, {{1.9, 4.1, -0.5}}, 7), 0);
  EXPECT_EQ(crossings_in_3d(rectangle, {{1.9, 3.9, 0.5}}, {{1.9, 3.9, 0.1}}, 7), 0);
  const auto triangle = triangle_wall({{0, 0, 0}}, {{2, 0, 0}}, {{0, 4, 0}});
  EXPECT_EQ(crossings_in_3d(triangle, {{0.9, 1.9, 0.5}}, {{0.9, 1.9, -0.5}}, 7), 1);
  EXPECT_EQ(crossings_in_3d(triangle, {{1.1, 2.1, 0.5}}, {{1.1, 2.1, -0.5}}, 7), 0);
  const auto disc = disc_wall({{1, 1, 1}}, {{0, 1, 0}}, 2.0);
  EXPECT_EQ(crossings_in_3d(disc, {{2.3, 0, 2.3}}, {{2.3, 2, 2.3}}, 7), 1);
  EXPECT_EQ(crossings_in_3d(disc, {{2.5, 0, 2.5}}, {{2.5, 2, 2.5}}, 7), 0);
  const auto ring = ring_wall({{0, 0, 0}}, {{0, 0, 1}}, 1.0, 2.0);
  EXPECT_EQ(crossings_in_3d(ring, {{1.5, 0, 1}}, {{1.5, 0, -1}}, 7), 1);
  EXPECT_EQ(crossings_in_3d(ring, {{0.9, 0, 1}}, {{0.9, 0, -1}}, 7), 0);
  EXPECT_EQ(crossings_in_3d(ring, {{2.1, 0, 1}}, {{2.1, 0, -1}}, 7), 0);
}

TEST(WallCrossings, CylindersAndCones) {
  testing::Draws draws(5);
  int through = 0;
  for (int k = 0; k < 300; ++k) {
    // A cylinder, a cone with its tip, or a flat funnel, about a slanting axis.
    const Vec<3> axis = draws.direction();
    const std::array<std::array<double, 3>, 3> sizes{{{1.0, 1.0, 2.0}, {0.0, 1.5, 1.0}, {0.4, 3.0, 0.3}}};
    const auto& [first, second, length] = sizes[static_cast<std::size_t>(k % 3)];
    const auto wall = frustum_wall(axis * (-0.5 * length), axis * (0.5 * length), first, second);
    const Vec<3> from = draws.vector(1.5);
    const Vec<3> to = draws.vector(1.5);
    // The way meets the wall where the distance from it falls to nothing: by small steps.
    constexpr int steps = 20000;
    const auto now = wall_now(wall, {}, 0.0);
    std::int64_t expected = 0;
    const double step = magnitude(Vec<3>(to - from)) / steps;
    double before = 1e9, last = 1e9;
    for (int n = 0; n <= steps; ++n) {
      const Vec<3> place = from + (to - from) * (static_cast<double>(n) / steps);
      const double height = above(wall, now, place).height;
      if (last < before && last <= height && last < step) ++expected;
      before = last;
      last = height;
    }
    EXPECT_EQ(crossings_in_3d(wall, from, to, 999), expected) << k;
    through += expected > 0 ? 1 : 0;
  }
  EXPECT_GT(through, 100);
  EXPECT_LT(through, 290);
}

// A paddle that turns about an axis, past a sphere at rest.
TEST(WallCrossings, ARectangleThatTurns) {
  auto wall = rectangle_wall({{0.5, 0, -1}}, {{1, 0, 0}}, {{0, 0, 2}});
  wall.motion.kind = WallMotion<3>::Kind::rotation;
  wall.motion.axis = {{0, 0, 1}};
  const auto count = [&](const Vec<3>& place) {
    WallCrossings<3> crossings(1);
    Grains<3> grains;
    Grain<3> grain;
    grain.radius = 0.5;
    grain.inverse_mass = 1.0;
    grain.position = place;
    grains.add(grain, 7);
    for (int k = 0; k < 10; ++k) {
      crossings.check(grains, {wall}, {wall_now(wall, {.displacement = 0.05 * std::numbers::pi * k}, 0.0)}, {}, k);
    }
    return crossings.until(grains, {wall}, {wall_now(wall, {.displacement = 0.5 * std::numbers::pi}, 0.0)}, {}, 10)[0]
        .count;
  };
  EXPECT_EQ(count({{0.7, 0.7, 0.9}}), 1);
  EXPECT_EQ(count({{0.7, 0.7, 1.1}}), 0);   // above it
  EXPECT_EQ(count({{0.3, 0.3, 0.0}}), 0);   // within its inner edge
  EXPECT_EQ(count({{1.1, 1.1, 0.0}}), 0);   // beyond its outer edge
  EXPECT_EQ(count({{0.7, -0.7, 0.0}}), 0);  // behind it
}

}  // namespace
}  // namespace repose
