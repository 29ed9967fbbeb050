// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/wall_crossings.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace repose
