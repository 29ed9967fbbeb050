// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace repose {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double interval = 0.5;  // times are then exact
constexpr int top_row = 20;
const double row_height = std::sqrt(0.75);

// Positions and radii of a track have single precision: 1e-6 for a pile of height 20, times the slope.
constexpr double single = 1e-4;

TrackedGrain<2> tracked(std::int64_t id, double x, double y, bool in_heap = true) {
  return {id, {static_cast<float>(x), static_cast<float>(y)}, 0.5F, 0.0F, in_heap};
}

/// Discs of diameter 1 in a triangular lattice: row k holds 21 - k of them, so both flanks rise at 60 degrees to the
/// apex at x = 0, y = 0.5 + 20 sqrt(3)/2. The part x > 0 is widened by the factor `widening`.
std::vector<TrackedGrain<2>> pile(double widening = 1.0) {
  std::vector<TrackedGrain<2>> grains;
  for (int row = 0; row <= top_row; ++row) {
    for (int k = 0; k <= top_row - row; ++k) {
      const double x = k - 0.5 * (top_row - row);
      grains.push_back(tracked(static_cast<std::int64_t>(grains.size()), x > 0.0 ? widening * x : x,
                               0.5 + row_height * static_cast<double>(row)));
    }
  }
  return grains;
}

MotionSettings settings() {
  MotionSettings chosen;
  chosen.moved = 0.5;
  chosen.least = 3;
  chosen.burst = 2.0;
  chosen.bin_width = 2.0;
  return chosen;
}

/// The index in a pile of the grain of a row that is `layer` positions in from the left or the right flank.
std::size_t place(int row, bool left, int layer = 0) {
  int index = 0;
  for (int below = 0; below < row; ++below) index += top_row + 1 - below;
  return static_cast<std::size_t>(left ? index + layer : index + top_row - row - layer);
}

// The surface by hand, in bins of 2 with edges at even x; c is the height of a row. Right: the highest disc of the bin
// from 2k is in row 20 - 4k, so h = 1 + 20 c - 2 c (x - 1), and the lowest point of the outermost disc of a row lies
// 1 + 2 c below it. Left: the highest disc of the bin up to -2k is in row 19 - 4k, so h = 1 + 19 c - 2 c (|x| - 1), and
// the lowest point of the outermost disc lies 1 + c below it. Perpendicular to 60 degrees the depth is half of that,
// plus c for every position further in. The centre of the apex bin is x = 1.
double depth_at(bool left, int layer) { return 0.5 * (1.0 + (left ? 1.0 : 2.0) * row_height) + layer * row_height; }

/// A track that starts with a pile. Grains that exchange positions move without changing the surface.
struct Story {
  Track<2> track;

  explicit Story(std::size_t moments) {
    for (std::size_t k = 0; k < moments; ++k) track.push_back({interval * static_cast<double>(k), pile()});
  }
  /// In interval k all grains at these positions exchange positions permanently.
  void rotate(std::size_t k, const std::vector<std::size_t>& places) {
    for (auto later = k + 1; later < track.size(); ++later) {
      auto& first = track[later].grains[who(k, places[0])];
      for (std::size_t p = 1; p < places.size(); ++p) {
        auto& other = track[later].grains[who(k, places[p])];
        std::swap(first.position[0], other.position[0]);
        std::swap(first.position[1], other.position[1]);
      }
    }
  }
  /// The grain at this position of the pile at time k.
  std::size_t who(std::size_t k, std::size_t place_of_pile) const {
    const auto at = pile()[place_of_pile];
    const auto& grains = track[k].grains;
    for (std::size_t g = 0; g < grains.size(); ++g) {
      if (grains[g].position[0] == at.position[0] && grains[g].position[1] == at.position[1]) return g;
    }
    ADD_FAILURE() << "nobody at place " << place_of_pile;
    return 0;
  }
};

void expect_avalanche(const Avalanche& found, double start, double end, std::size_t size, double depth, double left) {
  EXPECT_EQ(found.start, start);
  EXPECT_EQ(found.end, end);
  EXPECT_EQ(found.duration, end - start);
  EXPECT_EQ(found.size, size);
  EXPECT_NEAR(found.depth, depth, single);
  EXPECT_NEAR(found.left, left, 1e-12);
}

// Counts, times and fractions are exact; depths are within single precision.
TEST(MotionExact, PlantedAvalanches) {
  Story story(12);
  // Intervals 1 and 2, from 0.5 to 1.5: four grains of the right flank, then two of them and one from inside the left.
  story.rotate(1, {place(4, false), place(6, false), place(8, false), place(10, false)});
  story.rotate(2, {place(4, false), place(6, false), place(8, true, 2)});
  // Interval 3 is quiet. Interval 4, from 2.0 to 2.5: nine grains of the left flank and one from deep inside.
  std::vector<std::size_t> nine_and_one{place(2, true, 7)};
  for (int row = 4; row <= 12; ++row) nine_and_one.push_back(place(row, true));
  story.rotate(4, nine_and_one);
  // Interval 6: two grains, one too few. Interval 7: five grains move by 0.4, which is not enough.
  story.rotate(6, {place(5, false), place(9, false)});
  for (std::size_t k = 8; k < 12; ++k) {
    for (int layer = 4; layer < 9; ++layer) story.track[k].grains[place(1, true, layer)].position[0] += 0.4F;
  }
  // Five grains are released, fall (from time 6 on) and come to rest inside the pile in interval 8, at 4.5.
  for (std::size_t k = 6; k < 12; ++k) {
    for (int fifth = 0; fifth < 5; ++fifth) {
      story.track[k].grains.push_back(tracked(1000 + fifth, fifth, k < 9 ? 40.0 - 2.0 * static_cast<double>(k) : 3.0));
      story.track[k].grains.back().in_heap = k >= 9;
    }
  }
  // Interval 10, the last: three grains of the right flank.
  story.rotate(10, {place(7, false), place(9, false), place(11, false)});
  // A grain from the middle of the list is lost in interval 9.
  for (std::size_t k = 10; k < 12; ++k) {
    auto& grains = story.track[k].grains;
    grains.erase(grains.begin() + static_cast<std::ptrdiff_t>(place(3, true, 9)));
  }

  const auto motion = measure_motion(story.track, Box<2>{}, settings());
  ASSERT_EQ(motion.rows.size(), 11U);
  const std::vector<std::size_t> moved{0, 4, 3, 0, 10, 0, 2, 0, 0, 0, 3};
  const std::vector<std::size_t> moved_left{0, 0, 1, 0, 10, 0, 0, 0, 0, 0, 0};
  const double surface = depth_at(false, 0);
  const std::vector<double> depth{0, surface, depth_at(true, 2), 0, depth_at(true, 0), 0, surface, 0, 0, 0, surface};
  for (std::size_t k = 0; k < 11; ++k) {
    const auto& row = motion.rows[k];
    EXPECT_EQ(row.start, interval * static_cast<double>(k));
    EXPECT_EQ(row.end, interval * static_cast<double>(k + 1));
    // 231 grains are in the pile; the five count from the interval after their landing.
    EXPECT_EQ(row.grains, k < 9 ? 231U : 235U) << k;
    EXPECT_EQ(row.moved, moved[k]) << k;
    EXPECT_EQ(row.moved_left, moved_left[k]) << k;
    if (moved[k] == 0) {
      EXPECT_TRUE(std::isnan(row.depth)) << k;
    } else {
      EXPECT_NEAR(row.depth, depth[k], single) << k;
    }
    EXPECT_NEAR(row.angle_left_deg, 60.0, single);
    EXPECT_NEAR(row.angle_right_deg, 60.0, single);
  }
  ASSERT_EQ(motion.avalanches.size(), 3U);
  // Seven moves of five grains, one of them left; rank ceil(6.3) is the deepest.
  expect_avalanche(motion.avalanches[0], 0.5, 1.5, 5, depth_at(true, 2), 1.0 / 7.0);
  // Ten moves: rank 9 leaves the deepest out.
  expect_avalanche(motion.avalanches[1], 2.0, 2.5, 10, depth_at(true, 0), 1.0);
  expect_avalanche(motion.avalanches[2], 5.0, 5.5, 3, surface, 0.0);
  EXPECT_TRUE(std::isnan(motion.avalanches[0].waiting));
  EXPECT_EQ(motion.avalanches[1].waiting, 0.5);
  EXPECT_EQ(motion.avalanches[2].waiting, 2.5);
  EXPECT_TRUE(motion.bursts.empty());
}

// The energy at the end of an interval counts, for grains in the heap at both of its ends. All numbers are exact in
// single precision.
TEST(MotionExact, PlantedBursts) {
  Story story(12);
  const auto heat = [&](std::size_t moment, std::size_t grain, float energy) {
    story.track[moment].grains[grain].kinetic_energy = energy;
  };
  heat(2, 3, 1.5F);
  heat(2, 200, 1.5F);
  heat(3, 8, 2.0F);  // at the threshold, not above
  heat(5, 8, 2.5F);
  heat(6, 9, 4.0F);
  heat(8, 7, 100.0F);  // lands
  story.track[7].grains[7].in_heap = false;
  heat(9, 6, 100.0F);  // has lost its contacts
  story.track[9].grains[6].in_heap = false;
  heat(11, 0, 5.0F);
  const auto motion = measure_motion(story.track, Box<2>{}, settings());
  ASSERT_EQ(motion.rows.size(), 11U);
  const std::vector<double> energy{0.0, 3.0, 2.0, 0.0, 2.5, 4.0, 0.0, 0.0, 0.0, 0.0, 5.0};
  for (std::size_t k = 0; k < 11; ++k) EXPECT_EQ(motion.rows[k].kinetic_energy, energy[k]) << k;
  EXPECT_EQ(motion.rows[6].grains, 230U);
  EXPECT_EQ(motion.rows[7].grains, 230U);
  ASSERT_EQ(motion.bursts.size(), 3U);
  const std::vector<Burst> expected{{0.5, 1.0, 0.5, 0.0, 3.0}, {2.0, 3.0, 1.0, 1.0, 4.0}, {5.0, 5.5, 0.5, 2.0, 5.0}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(motion.bursts[k].start, expected[k].start) << k;
    EXPECT_EQ(motion.bursts[k].end, expected[k].end) << k;
    EXPECT_EQ(motion.bursts[k].duration, expected[k].duration) << k;
    EXPECT_EQ(motion.bursts[k].peak, expected[k].peak) << k;
  }
  EXPECT_TRUE(std::isnan(motion.bursts[0].waiting));
  EXPECT_EQ(motion.bursts[1].waiting, 1.0);
  EXPECT_EQ(motion.bursts[2].waiting, 2.0);
  EXPECT_TRUE(motion.avalanches.empty());
}

// The pile becomes wider on the right. The angles are those at the end, atan(sqrt(3)) and atan(sqrt(3)/2); the depths
// are those at the start. The base is at height 1, which changes no result.
TEST(MotionExact, DepthAtTheStartAnglesAtTheEnd) {
  Track<2> track{{0.0, pile()}, {interval, pile(2.0)}};
  for (auto& moment : track) {
    for (auto& grain : moment.grains) grain.position[1] += 1.0F;
  }
  auto chosen = settings();
  chosen.base_height = 1.0;
  chosen.moved = 9.6;  // only the lowest disc of the right flank moves by 10
  chosen.least = 1;
  const auto motion = measure_motion(track, Box<2>{}, chosen);
  ASSERT_EQ(motion.rows.size(), 1U);
  EXPECT_NEAR(motion.rows[0].angle_left_deg, 60.0, single);
  EXPECT_NEAR(motion.rows[0].angle_right_deg, std::atan(row_height) * degrees, single);
  EXPECT_EQ(motion.rows[0].moved, 1U);
  EXPECT_NEAR(motion.rows[0].depth, depth_at(false, 0), single);
  ASSERT_EQ(motion.avalanches.size(), 1U);
  EXPECT_EQ(motion.avalanches[0].size, 1U);
}

// In a box from 0 to 10, one grain is displaced by 0.2 across the side and has not moved; another is displaced by 0.7.
// Without a flank line, the depth of a disc at the surface is its diameter.
TEST(MotionExact, AcrossTheSideOfAPeriodicBox) {
  const Track<2> track{{0.0, {tracked(1, 9.9, 0.5), tracked(2, 9.8, 0.5)}},
                       {interval, {tracked(1, 0.1, 0.5), tracked(2, 0.5, 0.5)}}};
  Box<2> box;
  box.periodic = true;
  box.x_min = 0.0;
  box.x_max = 10.0;
  const auto motion = measure_motion(track, box, settings());
  ASSERT_EQ(motion.rows.size(), 1U);
  EXPECT_EQ(motion.rows[0].grains, 2U);
  EXPECT_EQ(motion.rows[0].moved, 1U);
  EXPECT_NEAR(motion.rows[0].depth, 1.0, single);
  EXPECT_TRUE(std::isnan(motion.rows[0].angle_left_deg));
  EXPECT_TRUE(std::isnan(motion.rows[0].angle_right_deg));
}

// The surface falls from 10 at x = 1 to 1 at x = 3. It passes below the disc at x = 1.9, whose depth is then 0.
TEST(MotionExact, DepthIsNeverNegative) {
  const Track<2> track{{0.0, {tracked(1, 1.9, 9.5), tracked(2, 3.0, 0.5)}},
                       {interval, {tracked(1, 5.0, 0.5), tracked(2, 3.0, 0.5)}}};
  const auto motion = measure_motion(track, Box<2>{}, settings());
  ASSERT_EQ(motion.rows.size(), 1U);
  EXPECT_EQ(motion.rows[0].moved, 1U);
  EXPECT_EQ(motion.rows[0].depth, 0.0);
}

// The first time may have no heap, and so no surface.
TEST(MotionExact, NoHeapAtTheStart) {
  const auto motion = measure_motion({{0.0, {}}, {interval, pile()}}, Box<2>{}, settings());
  ASSERT_EQ(motion.rows.size(), 1U);
  EXPECT_EQ(motion.rows[0].grains, 0U);
  EXPECT_TRUE(motion.avalanches.empty());
}

}  // namespace
}  // namespace repose
