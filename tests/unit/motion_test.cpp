// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

constexpr int rows = 20;
const double rise = std::sqrt(3.0) / 2.0;

/// A lattice pile at 60 degrees with its apex at x = 0 and its lowest centres at y = rise; ids run row by row from the
/// bottom left.
TrackMoment<2> pile(double time) {
  TrackMoment<2> moment{time, {}};
  for (int r = 0; r < rows; ++r) {
    for (int j = 0; j < rows - r; ++j) {
      TrackedGrain<2> grain;
      grain.id = static_cast<std::int64_t>(moment.grains.size());
      grain.position[0] = static_cast<float>(j + 0.5 * r - 0.5 * (rows - 1));
      grain.position[1] = static_cast<float>((r + 1) * rise);
      grain.radius = 0.5F;
      grain.kinetic_energy = 0.001F;
      grain.in_heap = true;
      moment.grains.push_back(grain);
    }
  }
  return moment;
}

/// The pile at times 0, 2, ... 40.
Track<2> quiet() {
  Track<2> track;
  for (int k = 0; k <= 20; ++k) track.push_back(pile(2.0 * k));
  return track;
}

/// Moves the last `count` grains of row `r` (the right flank) by `shift` to the right, from time `from` on.
void push_right(Track<2>& track, int r, int count, std::size_t from, float shift) {
  std::size_t end = 0;
  for (int k = 0; k <= r; ++k) end += static_cast<std::size_t>(rows - k);
  for (auto m = from; m < track.size(); ++m) {
    for (auto k = end - static_cast<std::size_t>(count); k < end; ++k) track[m].grains[k].position[0] += shift;
  }
}

MotionSettings settings(std::size_t least) {
  return {.moved = 0.5, .least = least, .burst = 1.0, .base_height = 0.0, .bin_width = 2.0};
}

TEST(Motion, NothingMovesInAQuietPile) {
  const auto motion = measure_motion(quiet(), {}, settings(1));
  ASSERT_EQ(motion.rows.size(), 20U);
  EXPECT_TRUE(motion.avalanches.empty());
  EXPECT_TRUE(motion.bursts.empty());
  for (const auto& row : motion.rows) {
    EXPECT_EQ(row.grains, 210U);
    EXPECT_EQ(row.moved, 0U);
    EXPECT_TRUE(std::isnan(row.depth));
    EXPECT_NEAR(row.kinetic_energy, 0.21, 1e-6);
    // In bins of two diameters the flank has steps of that length, which tilt a line over five bins by up to 2 deg.
    EXPECT_NEAR(row.angle_left_deg, 60.0, 2.0);
    EXPECT_NEAR(row.angle_right_deg, 60.0, 2.0);
  }
}

// Two grains of row 4 move in one interval and three grains of row 5 in the next: one avalanche of 5 grains. Two more
// grains, after a quiet interval, are another avalanche.
TEST(Motion, PlantedAvalanchesAreFound) {
  auto track = quiet();
  push_right(track, 4, 2, 3, 0.8F);    // between 4 and 6
  push_right(track, 5, 3, 4, 0.8F);    // between 6 and 8
  push_right(track, 7, 2, 6, 0.8F);    // between 10 and 12
  push_right(track, 9, 5, 9, 0.45F);   // too short
  push_right(track, 11, 1, 12, 0.8F);  // too few
  const auto motion = measure_motion(track, {}, settings(2));
  ASSERT_EQ(motion.avalanches.size(), 2U);
  const auto& first = motion.avalanches[0];
  EXPECT_EQ(first.start, 4.0);
  EXPECT_EQ(first.end, 8.0);
  EXPECT_EQ(first.duration, 4.0);
  EXPECT_EQ(first.size, 5U);
  EXPECT_TRUE(std::isnan(first.waiting));
  EXPECT_EQ(first.left, 0.0);
  const auto& second = motion.avalanches[1];
  EXPECT_EQ(second.start, 10.0);
  EXPECT_EQ(second.size, 2U);
  EXPECT_EQ(second.waiting, 2.0);
  EXPECT_EQ(motion.rows[12].moved, 0U);
  EXPECT_EQ(motion.rows[11].moved, 1U);
}

TEST(Motion, AGrainThatMovesTwiceCountsOnce) {
  auto track = quiet();
  push_right(track, 4, 2, 3, 0.8F);
  push_right(track, 4, 2, 4, 0.8F);
  const auto motion = measure_motion(track, {}, settings(2));
  ASSERT_EQ(motion.avalanches.size(), 1U);
  EXPECT_EQ(motion.avalanches[0].size, 2U);
  EXPECT_EQ(motion.avalanches[0].duration, 4.0);
}

TEST(Motion, AnAvalancheMayLastUntilTheEnd) {
  auto track = quiet();
  push_right(track, 4, 3, 20, 0.8F);
  const auto motion = measure_motion(track, {}, settings(3));
  ASSERT_EQ(motion.avalanches.size(), 1U);
  EXPECT_EQ(motion.avalanches[0].end, 40.0);
}

TEST(Motion, TheSideIsThatOfTheStart) {
  auto track = quiet();
  for (auto m = std::size_t{5}; m < track.size(); ++m) {
    for (std::size_t k = 0; k < 4; ++k) track[m].grains[k].position[0] -= 1.0F;  // bottom left corner
  }
  push_right(track, 0, 1, 5, 1.0F);
  const auto motion = measure_motion(track, {}, settings(5));
  ASSERT_EQ(motion.avalanches.size(), 1U);
  EXPECT_DOUBLE_EQ(motion.avalanches[0].left, 0.8);
  EXPECT_EQ(motion.rows[4].moved_left, 4U);
}

// The outermost k grains of a row lie k layers deep: the lowest point of the k-th is (k - 1) rise + 1 below the line
// through the tops, perpendicular to it. The surface in bins of two diameters lies within a grain of that line.
TEST(Motion, DepthOfTheMovingLayer) {
  for (const int layers : {1, 3, 5}) {
    auto track = quiet();
    push_right(track, 6, layers, 7, 0.8F);
    const auto motion = measure_motion(track, {}, settings(1));
    ASSERT_EQ(motion.avalanches.size(), 1U);
    EXPECT_NEAR(motion.avalanches[0].depth, (layers - 1) * rise + 1.0, 1.0) << layers;
  }
}

TEST(Motion, DepthIsTheNinetiethPercentile) {
  auto track = quiet();
  push_right(track, 0, 10, 7, 0.8F);
  const auto deepest_but_one = measure_motion(track, {}, settings(1)).rows[6].depth;
  auto other = quiet();
  push_right(other, 0, 9, 7, 0.8F);
  const auto deepest = measure_motion(other, {}, settings(1)).rows[6].depth;
  EXPECT_DOUBLE_EQ(deepest_but_one, deepest);  // ranks 9 of 10 and 9 of 9
}

TEST(Motion, GrainsThatLandOrLeaveDoNotCount) {
  auto track = quiet();
  for (std::size_t m = 0; m < track.size(); ++m) {
    TrackedGrain<2> falling;
    falling.id = 1000;
    falling.position[0] = 8.0F;
    falling.position[1] = 60.0F - 2.0F * static_cast<float>(m);
    falling.radius = 0.5F;
    falling.kinetic_energy = 100.0F;
    falling.in_heap = m >= 10;
    track[m].grains.push_back(falling);
    if (m > 10) track[m].grains.back().position[1] = track[10].grains.back().position[1];
  }
  track[15].grains.erase(track[15].grains.begin() + 3);
  const auto motion = measure_motion(track, {}, settings(1));
  EXPECT_TRUE(motion.avalanches.empty());
  EXPECT_EQ(motion.rows[9].grains, 210U);  // was in flight at the start
  EXPECT_EQ(motion.rows[10].grains, 211U);
  EXPECT_EQ(motion.rows[14].grains, 210U);  // one is missing at the end
  EXPECT_EQ(motion.rows[15].grains, 210U);  // and at the start
  EXPECT_EQ(motion.rows[16].grains, 211U);
}

TEST(Motion, BurstsOfKineticEnergy) {
  auto track = quiet();
  for (const auto& [moment, energy] : {std::pair{4, 2.0F}, {5, 7.0F}, {9, 3.0F}}) {
    track[static_cast<std::size_t>(moment)].grains[17].kinetic_energy = energy;
  }
  const auto motion = measure_motion(track, {}, settings(1));
  ASSERT_EQ(motion.bursts.size(), 2U);
  EXPECT_EQ(motion.bursts[0].start, 6.0);
  EXPECT_EQ(motion.bursts[0].end, 10.0);
  EXPECT_NEAR(motion.bursts[0].peak, 7.209, 1e-5);
  EXPECT_EQ(motion.bursts[1].waiting, 6.0);
  EXPECT_EQ(motion.bursts[1].duration, 2.0);
}

// A grain that crosses the side of a periodic box has the displacement of the nearest image.
TEST(Motion, PeriodicSide) {
  Box<2> box;
  box.periodic = true;
  box.x_min = -10.0;
  box.x_max = 10.0;
  TrackedGrain<2> grain;
  grain.position[0] = 9.9F;
  grain.radius = 0.5F;
  grain.in_heap = true;
  Track<2> track = {{0.0, {grain}}, {1.0, {grain}}};
  track[1].grains[0].position[0] = -9.9F;
  EXPECT_EQ(measure_motion(track, box, settings(1)).rows[0].moved, 0U);
  track[1].grains[0].position[0] = -9.0F;
  EXPECT_EQ(measure_motion(track, box, settings(1)).rows[0].moved, 1U);
}

TEST(Motion, NoneWithoutATrack) {
  EXPECT_TRUE(measure_motion({}, {}, settings(1)).rows.empty());
  EXPECT_TRUE(measure_motion({pile(0.0)}, {}, settings(1)).rows.empty());
}

}  // namespace
}  // namespace repose
