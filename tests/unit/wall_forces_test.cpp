// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/wall_forces.hpp"

#include "repose/analysis/wall_span.hpp"
#include "repose/scene/read.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

FlatWall facing(double x, double y, double nx, double ny) {
  const double length = std::hypot(nx, ny);
  return {{{x, y}}, {{nx / length, ny / length}}};
}

// A floor between upright planes is as long as they are apart; these reach from the floor to the top of the grains; a
// fixed grain above does not count.
TEST(WallSpans, APlaneReachesToOtherPlanesAndElseToTheGrains) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.5), 0);
  grains.add(unit_disc(1.0, 6.0), 1);
  grains.add(unit_disc(1.0, 9.0, true), 2);
  const auto spans =
      wall_spans({facing(7.0, 0.0, 0.0, 1.0), facing(-2.0, 3.0, 1.0, 0.0), facing(4.0, 3.0, -1.0, 0.0)}, grains, {});
  EXPECT_NEAR(spans[0].length, 6.0, 1e-12);
  EXPECT_NEAR(spans[0].middle[0], 1.0, 1e-12);
  EXPECT_NEAR(spans[0].middle[1], 0.0, 1e-12);
  EXPECT_NEAR(spans[1].length, 6.5, 1e-12);
  EXPECT_NEAR(spans[1].middle[0], -2.0, 1e-12);
  EXPECT_NEAR(spans[1].middle[1], 3.25, 1e-12);
  EXPECT_NEAR(spans[2].length, 6.5, 1e-12);
}

// A slope of 45 degrees that meets the floor at x = 1 and a ceiling at height 3.
TEST(WallSpans, InclinedFiniteAndPeriodicWalls) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.5), 0);
  const FlatWall piece{{{1.0, 2.0}}, {{0.0, 1.0}}, 1.5};
  const auto spans = wall_spans(
      {facing(1.0, 0.0, -1.0, 1.0), facing(0.0, 0.0, 0.0, 1.0), facing(0.0, 3.0, 0.0, -1.0), piece}, grains, {});
  EXPECT_NEAR(spans[0].length, 3.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(spans[0].middle[0], 2.5, 1e-12);
  EXPECT_NEAR(spans[0].middle[1], 1.5, 1e-12);
  EXPECT_NEAR(spans[1].length, 1.5, 1e-12);  // from the rim of the grain, -1/2, to the slope
  EXPECT_EQ(spans[3].length, 3.0);
  EXPECT_EQ(spans[3].middle, piece.point);
  const Box<2> box{.periodic = true, .x_min = -4.0, .x_max = 6.0};
  const auto floor = wall_spans({facing(-30.0, 2.0, 0.0, 1.0)}, grains, box);
  EXPECT_EQ(floor[0].length, 10.0);
  EXPECT_EQ(floor[0].middle, (Vec<2>{{1.0, 2.0}}));
  EXPECT_EQ(wall_spans({facing(0.0, 0.0, 0.0, 1.0)}, {}, {})[0].length, 0.0);
}

// A disc at x = 3 pushes on a floor with the middle at x = 1, to the right as well: M = lever times force, the lever in
// the plane of the floor.
TEST(WallMoments, LeverTimesForce) {
  Grains<2> grains;
  grains.add(unit_disc(3.0, 0.5), 7);
  Contact<2> contact;
  contact.first = 7;
  contact.second = wall_partner(0);
  contact.normal = {{0.0, 1.0}};
  contact.first_lever = 0.5;
  contact.normal_force = 5.0;
  contact.tangential_force = 1.0;
  const auto moments = wall_moments({{{{1.0, 0.0}}, 4.0}}, grains, Contacts<2>{{contact}}, {});
  EXPECT_NEAR(moments[0], -10.0, 1e-12);
}

// Rows of 1 T; the means are over the last three, which cover a window of 2.5. Pressure is positive into the wall,
// shear along z x n: to the left for a floor.
TEST(WallForces, MeansOverTheRowsThatCoverTheWindow) {
  Record<2> record;
  record.scene = scene_from_text(
      "stop = { time = 9 }\noutput = { window = 2.5 }\n[[plane]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n"
      "[[grain]]\nposition = [0, 1]\n",
      "scene.toml");
  record.walls = recorded_walls(record.scene, {}, 9.0);
  for (int k = 1; k <= 9; ++k) {
    SeriesRow row;
    row.time = k;
    record.series.push_back(row);
    record.wall_series.push_back({0.0, Vec<2>{{-0.5 * k, -2.0 * k}}, 4.0, 0.25 * k});
  }
  const auto forces = mean_wall_forces(record);
  ASSERT_EQ(forces.walls.size(), 1U);
  EXPECT_EQ(forces.window_start, 6.0);
  EXPECT_EQ(forces.window_end, 9.0);
  const auto& floor = forces.walls[0];
  EXPECT_EQ(floor.name, "floor");
  EXPECT_NEAR(floor.pressure, 4.0, 1e-12);
  EXPECT_NEAR(floor.shear, 1.0, 1e-12);
  EXPECT_NEAR(floor.moment, 2.0, 1e-12);
  EXPECT_NEAR(floor.force[1], -16.0, 1e-12);
  record.series.clear();
  EXPECT_TRUE(mean_wall_forces(record).walls.empty());
}

}  // namespace
}  // namespace repose
