// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/sources/drop.hpp"
#include "repose/simulation/sources/initial.hpp"
#include "repose/simulation/sources/rain.hpp"
#include "repose/simulation/sources/room.hpp"
#include "repose/simulation/sources/source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace repose {
namespace {

const std::string stop = "stop = { time = 1 }\n";
const std::string hooke = "contact = { normal = { law = \"hooke\", stiffness = 1e4 } }\n";

constexpr TimeSteps leapfrog{0.001, true};

const SourceView no_apex{[] { return 0.0; }, {}};

/// The smallest distance between the surfaces of two grains [L], over all pairs.
double least_gap(const Grains<2>& grains, const Box<2>& box) {
  double least = 1e300;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto d = separation(grains.line[i].position, grains.line[j].position, box);
      least = std::min(least, magnitude(d) - grains.line[i].radius - grains.line[j].radius);
    }
  }
  return least;
}

Scene raining(const std::string& more) {
  return scene_from_text(stop + hooke +
                             "grains = { polydispersity = 0.5 }\nbox = { x = \"periodic\", half_width = 20 }\n"
                             "source = { kind = \"rain\", count = 600, rate = 100, height = 9, " +
                             more + " }\n",
                         "scene.toml");
}

// At most 1 + t rate grains are released by time t, and all of them at the next release unless they wait. None overlap.
TEST(Rain, GrainsOfOneMomentDoNotOverlap) {
  const auto scene = raining("velocity = [0.5, -2.0]");
  Rain<2> rain(scene, *scene.source.as<RainSource>(), leapfrog, 7);
  Grains<2> grains;
  std::size_t most = 0;
  long step = 0;
  while (!rain.done() && step < 1000000) {
    step = std::max(step, leapfrog.count(rain.due()));
    ASSERT_EQ(step % 100, 0) << "rain falls every 0.1 sqrt(d/g)";
    Grains<2> together;
    rain.release(together, leapfrog.after(step), no_apex);
    EXPECT_GE(least_gap(together, make_box(scene)), -1e-12);
    most = std::max(most, together.size());
    for (std::size_t k = 0; k < together.size(); ++k) {
      const auto& grain = together.line[k];
      EXPECT_LE(std::fabs(grain.position[0]), 20.0);
      EXPECT_EQ(grain.position[1], 9.0);
      EXPECT_EQ(grain.velocity[0], 0.5);
      EXPECT_DOUBLE_EQ(grain.velocity[1], step > 0 ? -2.0 + 0.0005 : -2.0);
      grains.add(grain, together.id[k]);
    }
    EXPECT_LE(static_cast<double>(grains.size()), 1.0 + 100.0 * 0.001 * static_cast<double>(step) + 1e-6);
  }
  EXPECT_EQ(grains.size(), 600U);
  EXPECT_EQ(most, 10U);
  EXPECT_EQ(grains.id.front(), 7);
  EXPECT_EQ(grains.id.back(), 606);
  // The last grain, number 599, is due at 5.99, in the batch of 6.0.
  EXPECT_EQ(step, 6000);
}

// A source that is destroyed and made again with the same state continues with the same grains: nothing else is random.
TEST(Rain, GrainsDependOnTheirNumberAlone) {
  const auto scene = raining("half_width = 20");
  Rain<2> one(scene, *scene.source.as<RainSource>(), leapfrog, 0);
  Rain<2> other(scene, *scene.source.as<RainSource>(), leapfrog, 0);
  Grains<2> all;
  Grains<2> late;
  one.release(all, 1.0, no_apex);
  for (long step = 0; step <= 1000; step += 100) {
    Grains<2> now;
    if (other.due() <= leapfrog.after(step)) other.release(now, leapfrog.after(step), no_apex);
    for (const auto& grain : now.line) late.add(grain, 0);
  }
  ASSERT_GE(all.size(), 30U);  // grains that found room immediately on a line of 40
  EXPECT_EQ(late.size(), 101U);
  EXPECT_EQ(all.line[0].position[0], late.line[0].position[0]);
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all.line[k].radius, late.line[k].radius);
}

TEST(Rain, HeightAboveTheApex) {
  const auto scene = raining("height_above = \"apex\"");
  Rain<2> rain(scene, *scene.source.as<RainSource>(), leapfrog, 0);
  Grains<2> grains;
  rain.release(grains, 0.0, {[] { return 3.25; }, {}});
  ASSERT_EQ(grains.size(), 1U);
  EXPECT_EQ(grains.line[0].position[1], 12.25);
}

// Compared with all pairs, also across the sides of a periodic box: 400 positions among 60 grains.
TEST(Room, AgreesWithAllPairs) {
  for (const bool periodic : {false, true}) {
    Box<2> box;
    box.periodic = periodic;
    box.x_min = -10.0;
    box.x_max = 10.0;
    Grains<2> grains;
    const auto disc = [](std::uint64_t k, double spread) {
      Grain<2> grain;
      grain.radius = 0.1 + 0.4 * uniform(1, Purpose::grain_size, k);
      grain.position = {{20.0 * uniform(2, Purpose::grain_size, k) - 10.0,
                         5.0 + spread * (uniform(3, Purpose::grain_size, k) - 0.5)}};
      return grain;
    };
    for (std::uint64_t k = 0; k < 60; ++k) grains.add(disc(k, 4.0), static_cast<std::int64_t>(k));
    const Room room(grains, box, 5.0, 0.5, 1.2);
    int free = 0;
    for (std::uint64_t k = 1000; k < 1400; ++k) {
      const auto candidate = disc(k, 0.0);
      const bool expected = std::none_of(grains.line.begin(), grains.line.end(), [&](const Grain<2>& other) {
        const double near = 1.2 * (candidate.radius + other.radius);
        return magnitude(separation(candidate.position, other.position, box)) < near;
      });
      EXPECT_EQ(room.is_free(candidate), expected);
      free += expected ? 1 : 0;
    }
    EXPECT_GT(free, 50);
    EXPECT_LT(free, 350);
  }
}

const std::string two_species =
    "[[material]]\nname = \"light\"\n[[material]]\nname = \"heavy\"\ndensity = 3.0\n"
    "[[species]]\nname = \"a\"\nmaterial = \"heavy\"\nshare = 1\nsizes = { kind = \"uniform\", low = 0.5, high = 0.7 "
    "}\n"
    "[[species]]\nname = \"b\"\nmaterial = \"light\"\nshare = 3\nsizes = { diameter = 2.0 }\n";

// Fractions of 20000 grains are within 4 standard errors. By number, a fraction p has the error sqrt(p (1 - p) / n). By
// mass, the fraction by number of the heavy grains is 1 / m_a over 1 / m_a + 3 / m_b, with m_a = 3 <d^2> and m_b = 4.
TEST(GrainDraw, FractionsByNumberAndByMass) {
  const double mean_mass = 3.0 * (0.25 + 0.35 + 0.49) / 3.0;
  for (const bool by_mass : {false, true}) {
    const auto scene =
        scene_from_text(stop + hooke + (by_mass ? "grains = { shares = \"mass\" }\n" : "") +
                            "source = { kind = \"pour\", count = 5, rate = 1, height = 5 }\n" + two_species,
                        "scene.toml");
    EXPECT_EQ(scene.smallest_diameter(), 0.5);
    EXPECT_EQ(scene.largest_diameter(), 2.0);
    const GrainDraw<2> draw(scene, Purpose::grain_species, Purpose::grain_size);
    double heavy = 0.0;
    constexpr int n = 20000;
    for (std::uint64_t k = 0; k < n; ++k) {
      const auto [grain, material] = draw(k);
      if (material == 0) {
        EXPECT_EQ(grain.radius, 1.0);
        EXPECT_DOUBLE_EQ(grain.mass, 4.0);
        continue;
      }
      EXPECT_DOUBLE_EQ(grain.mass, 12.0 * grain.radius * grain.radius);
      heavy += 1.0;
    }
    const double p = by_mass ? (1.0 / mean_mass) / (1.0 / mean_mass + 3.0 / 4.0) : 0.25;
    EXPECT_NEAR(heavy / n, p, 4.0 * std::sqrt(p * (1.0 - p) / n));
  }
}

// Neighbours touch to rounding, except for the rest of a periodic width, which is less than the largest disc and is
// spread over all gaps. Heights are within the roughness, in both halves of its range. Only neighbours are close.
TEST(DepositedBase, LetsNothingThrough) {
  for (const bool periodic : {false, true}) {
    const auto scene =
        scene_from_text(stop + hooke + "base = { kind = \"deposited\", roughness = 0.25, half_width = 20 }\n" +
                            (periodic ? "box = { x = \"periodic\" }\n" : "") +
                            "source = { kind = \"pour\", count = 1, rate = 1, height = 9 }\n" + two_species,
                        "scene.toml");
    const auto base = initial_grains(scene);
    const auto box = make_box(scene);
    const auto n = base.size();
    ASSERT_GT(n, 20U);
    double lowest = 0.0;
    double highest = -1.0;
    double widest = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const auto& disc = base.line[k];
      EXPECT_TRUE(disc.fixed());
      EXPECT_TRUE(base.base[k]);
      lowest = std::min(lowest, disc.position[1]);
      highest = std::max(highest, disc.position[1]);
      if (!periodic && k + 1 == n) break;
      const auto& next = base.line[(k + 1) % n];
      widest = std::max(widest, magnitude(separation(next.position, disc.position, box)) - next.radius - disc.radius);
    }
    EXPECT_GE(lowest, -0.25);
    EXPECT_LT(lowest, -0.125);
    EXPECT_LE(highest, 0.0);
    EXPECT_GT(highest, -0.125);
    EXPECT_GE(least_gap(base, box), -1e-12);
    EXPECT_LT(widest, periodic ? 2.0 / static_cast<double>(n) : 1e-12);
    if (periodic) continue;
    EXPECT_NEAR(base.line.front().position[0], -base.line.back().position[0], 1e-9);
  }
}

Grains<2> block(const std::string& more, const std::string& base) {
  const auto scene = scene_from_text(stop + hooke + base + "box.half_width = 10\n" +
                                         "source = { kind = \"lattice\", rows = 4, columns = 6, " + more + " }\n",
                                     "scene.toml");
  auto grains = initial_grains(scene);
  std::vector<std::uint32_t> moving;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    if (!grains.line[k].fixed()) moving.push_back(k);
  }
  EXPECT_GE(least_gap(grains, make_box(scene)), -1e-12);
  grains.reorder(moving);
  return grains;
}

// Touching grains lie in the hollows of the row, and each row in the hollows of the row below.
TEST(Block, NestsInTheRow) {
  const auto grains = block("x = 1.2", "base = { kind = \"row\", half_width = 9 }\n");
  ASSERT_EQ(grains.size(), 24U);
  const double rise = std::sqrt(0.75);
  for (std::size_t k = 0; k < 24; ++k) {
    const auto row = static_cast<double>(k / 6);
    EXPECT_NEAR(grains.line[k].position[1], rise * (row + 1.0), 1e-12);
    const double from_hollow = grains.line[k].position[0] - (k / 6 % 2 == 0 ? 0.5 : 0.0);
    EXPECT_NEAR(from_hollow, std::round(from_hollow), 1e-12);
  }
}

// Each grain is displaced by up to half a gap, so grains do not overlap. No two displacements are equal.
TEST(Block, JitterWithinTheGap) {
  const auto regular = block("gap = 0.3", "base = { kind = \"plane\" }\n");
  const auto loose = block("gap = 0.3, jitter = 1.0", "base = { kind = \"plane\" }\n");
  ASSERT_EQ(loose.size(), 24U);
  double largest = 0.0;
  for (std::size_t k = 0; k < 24; ++k) {
    largest = std::max(largest, magnitude(loose.line[k].position - regular.line[k].position));
  }
  EXPECT_LE(largest, 0.15);
  EXPECT_GT(largest, 0.1);
  EXPECT_NEAR(regular.line[0].position[1], 0.8, 1e-12);
}

struct PlacedPile {
  Grains<2> base, moving;
};

PlacedPile pile(const std::string& source, const std::string& more) {
  const auto scene =
      scene_from_text(stop + hooke + more + "source = { kind = \"lattice\", " + source + " }\n", "scene.toml");
  const auto all = initial_grains(scene);
  EXPECT_GE(least_gap(all, make_box(scene)), -1e-9);
  PlacedPile placed;
  std::int64_t moving = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool fixed = all.line[k].fixed();
    (fixed ? placed.base : placed.moving).add(all.line[k], all.id[k]);
    moving += fixed ? 0 : 1;
  }
  EXPECT_EQ(scene.source->placed(), moving);
  return placed;
}

const std::string plane = "base = { kind = \"plane\" }\nbox.half_width = 300\n";
std::string row_of(int half_width) {
  return "base = { kind = \"row\", half_width = " + std::to_string(half_width) + " }\n";
}

// The counts of discs that Liffman et al. (1992) give: 360 and 5490 at 30 degrees, 1035 in 45 rows at 60; by the slope
// too, 45 discs wide. With the base row as the lowest row of the pile, the others are left.
TEST(Pile, HasTheGrainsOfThePaper) {
  EXPECT_EQ(pile("rows = 45", plane).moving.size(), 1035U);
  EXPECT_EQ(pile("base_count = 45", plane).moving.size(), 1035U);
  EXPECT_EQ(pile("base_count = 45, slope = 30", plane).moving.size(), 360U);
  EXPECT_EQ(pile("base_count = 45, slope = 30, fixed_base = true", row_of(22)).moving.size(), 315U);
  EXPECT_EQ(pile("rows = 45, fixed_base = true", row_of(22)).moving.size(), 990U);
  const auto scene = scene_from_text(
      stop + hooke + plane + "source = { kind = \"lattice\", base_count = 180, slope = 30 }\n", "scene.toml");
  EXPECT_EQ(scene.source->placed(), 5490);
}

// Every grain lies under the surface, and one more at the end of any row would lie above it.
TEST(Pile, FillsTheTentUnderItsTwoSlopes) {
  const double lower = std::tan(30.0 * std::numbers::pi / 180.0);
  const double upper = std::tan(45.0 * std::numbers::pi / 180.0);
  const double to_break = 0.38 * 44.0;
  const auto surface = [&](double x) {
    const double from_corner = 22.0 - std::fabs(x);
    return lower * std::min(from_corner, to_break) + upper * std::max(from_corner - to_break, 0.0);
  };
  const auto tent = pile("base_count = 45, slope = 30, upper_slope = 45, break_at = 0.38", plane).moving;
  std::map<long, double> end_of_row;
  for (const auto& grain : tent.line) {
    const double height = grain.position[1] - 0.5;
    EXPECT_LE(height, surface(grain.position[0]) + 1e-8);
    auto& end = end_of_row[std::lround(height / std::sqrt(0.75))];
    end = std::max(end, grain.position[0]);
  }
  for (const auto& [row, end] : end_of_row) {
    EXPECT_GT(static_cast<double>(row) * std::sqrt(0.75), surface(end + 1.0)) << "row " << row;
  }
  // The apex is 14.93 diameters high. Row 16 has a disc below it, at 13.86; those of row 17, at 14.72, would lie half a
  // diameter beside it, where the surface is at 14.43.
  EXPECT_EQ(end_of_row.size(), 17U);
}

// The lowest row of the pile is that of the base: its second row lies in the hollows of as many base discs as it has
// itself and one more, in the middle of them.
TEST(Pile, StandsOnItsOwnLowestRow) {
  for (const int count : {8, 9}) {
    const auto made =
        pile("base_count = " + std::to_string(count) + ", slope = 60, x = 0.3, fixed_base = true", row_of(6));
    ASSERT_EQ(made.base.size(), 13U);
    ASSERT_EQ(made.moving.size(), static_cast<std::size_t>(count * (count - 1) / 2));
    double least = 1e9;
    double most = -1e9;
    for (const auto& grain : made.moving.line) {
      if (grain.position[1] > 1.0) continue;
      EXPECT_NEAR(grain.position[1], std::sqrt(0.75), 1e-12);
      least = std::min(least, grain.position[0]);
      most = std::max(most, grain.position[0]);
    }
    EXPECT_NEAR(most - least, count - 2, 1e-12);
    EXPECT_NEAR(0.5 * (least + most), count == 8 ? 0.5 : 0.0, 1e-12);
  }
}

// Sizes are drawn at the places of the largest: the places are those of equal grains, the sizes uniform below.
TEST(Pile, SpreadsSizesAtThePlacesOfTheLargest) {
  const auto equal = pile("rows = 30", plane).moving;
  const auto spread = pile("rows = 30", "grains.polydispersity = 0.1\n" + plane).moving;
  ASSERT_EQ(spread.size(), equal.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < equal.size(); ++k) {
    EXPECT_EQ(magnitude(spread.line[k].position - equal.line[k].position), 0.0);
    const double diameter = 2.0 * spread.line[k].radius;
    EXPECT_LE(diameter, 1.0);
    EXPECT_GE(diameter, 0.9);
    EXPECT_NEAR(spread.line[k].mass, diameter * diameter, 1e-12);
    sum += diameter;
  }
  // The mean of 465 draws of deviation 0.0289 is within four standard errors of 0.95.
  EXPECT_NEAR(sum / static_cast<double>(equal.size()), 0.95, 4.0 * 0.0289 / std::sqrt(465.0));
}

}  // namespace
}  // namespace repose
