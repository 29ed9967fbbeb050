// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/pour.hpp"

#include "repose/scene/read.hpp"
#include "repose/scene/sources/drop.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace repose {
namespace {

Scene pouring(const std::string& more) {
  return scene_from_text("source = { kind = \"pour\", count = 400, rate = 2.0, " + more +
                             " }\nstop = { time = 1 }\ngrains = { polydispersity = 0.1 }\n",
                         "scene.toml");
}

constexpr TimeSteps leapfrog{0.001, true};

const SourceView no_apex{[] { return 0.0; }, {}};

/// Releases all grains that are due up to a time.
Grains<2> released_by(Pour<2>& pour, double time) {
  Grains<2> grains;
  while (pour.due() <= time) {
    Grains<2> one;
    if (!pour.release(one, pour.due(), no_apex)) break;
    grains.add(one.line[0], one.id[0]);
  }
  return grains;
}

// The count of the paper is 0.62 t + 1 grains by time t; here the rate is 2.
TEST(Pour, CountGrowsWithTimeFromOne) {
  const auto scene = pouring("height = 50.0");
  Pour<2> pour(scene, *scene.source.as<PourSource>(), leapfrog, 10);
  EXPECT_EQ(released_by(pour, 0.0).size(), 1U);
  EXPECT_EQ(released_by(pour, 10.2).size(), 20U);
  EXPECT_EQ(pour.released(), 21);
  released_by(pour, 1e9);
  EXPECT_TRUE(pour.done());
}

// Positions are uniform in +-w, sizes uniform in [(1 - p) d, d] (standard deviation p d / sqrt(12)), masses
// proportional to the square of the size, all within 4 standard errors of 400 grains. Grains are released from rest:
// half a step later the speed is g dt / 2.
TEST(Pour, PlacesAndSizes) {
  const auto scene = pouring("height = 50.0, half_width = 4.0, x = 1.0");
  Pour<2> pour(scene, *scene.source.as<PourSource>(), leapfrog, 0);
  const auto grains = released_by(pour, 1e9);
  double x = 0.0;
  double x2 = 0.0;
  double size = 0.0;
  for (const auto& grain : grains.line) {
    EXPECT_LE(std::fabs(grain.position[0] - 1.0), 4.0);
    EXPECT_EQ(grain.position[1], 50.0);
    // The kick of the first step is half a kick.
    const double first_kick = &grain == &grains.line.front() ? 0.0005 : 0.001;
    EXPECT_DOUBLE_EQ(grain.velocity[1] - first_kick, -0.0005);
    EXPECT_GE(grain.radius, 0.45);
    EXPECT_LE(grain.radius, 0.5);
    EXPECT_DOUBLE_EQ(grain.mass, 4.0 * grain.radius * grain.radius);
    x += (grain.position[0] - 1.0) / 400.0;
    x2 += std::pow(grain.position[0] - 1.0, 2) / 400.0;
    size += 2.0 * grain.radius / 400.0;
  }
  EXPECT_NEAR(x, 0.0, 4.0 * 4.0 / std::sqrt(3.0 * 400.0));
  EXPECT_NEAR(x2, 16.0 / 3.0, 4.0 * 16.0 * std::sqrt(4.0 / 45.0 / 400.0));
  EXPECT_NEAR(size, 0.95, 4.0 * 0.1 / std::sqrt(12.0 * 400.0));
}

// No grain is released in reach of another: if the opening is full, the next grain waits.
TEST(Pour, WaitsForRoom) {
  const auto scene = pouring("height = 50.0, half_width = 2.0");
  Pour<2> pour(scene, *scene.source.as<PourSource>(), leapfrog, 0);
  Grains<2> grains;
  double time = 5.0;  // 11 grains are due
  EXPECT_TRUE(pour.release(grains, time, no_apex));
  EXPECT_GT(pour.due(), time);
  EXPECT_GE(grains.size(), 2U);
  EXPECT_LE(grains.size(), 5U);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto d = grains.line[i].position - grains.line[j].position;
      EXPECT_GE(magnitude(d), 1.2 * (grains.line[i].radius + grains.line[j].radius));
    }
  }
  time += 1.0;
  EXPECT_FALSE(pour.release(grains, time, no_apex));
  EXPECT_DOUBLE_EQ(pour.waiting(time), 1.0);  // since the last release
  Grains<2> emptied;
  EXPECT_TRUE(pour.release(emptied, pour.due(), no_apex));
}

}  // namespace
}  // namespace repose
