// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The rough base of spheres that were dropped at random.
#include "repose/scene/bases/deposited_bed.hpp"

#include "repose/core/errors.hpp"
#include "repose/methods/deposition/spheres_columns.hpp"
#include "repose/scene/bases/deposited.hpp"
#include "repose/scene/read.hpp"
#include "repose/simulation/sources/initial.hpp"
#include "support/deposited_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace repose {
namespace {

std::string text_of(const std::string& base, const std::string& more = "") {
  return "dimension = 3\nstop = { time = 1 }\nsource = { kind = 'pour', count = 1, rate = 1.0 }\nbase = { kind = "
         "'deposited', " +
         base + " }\n" + more;
}

Grains<3> deposited(double radius, double polydispersity, int seed = 1) {
  return initial_grains<3>(scene_from_text(text_of("radius = " + std::to_string(radius),
                                                   "seed = " + std::to_string(seed) + "\ngrains = { polydispersity = " +
                                                       std::to_string(polydispersity) + " }\n"),
                                           "scene"));
}

TEST(DepositedBed, SpheresOfTheSurface) {
  for (const double polydispersity : {0.0, 0.3, 0.5}) {
    const auto grains = deposited(12.0, polydispersity);
    double highest = -1e300;
    double lowest = 1e300;
    double largest = 0.0;
    double smallest = 1.0;
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const auto& grain = grains.line[k];
      EXPECT_TRUE(grain.fixed() && grains.base[k]);
      EXPECT_EQ(grains.id[k], static_cast<std::int64_t>(k));
      EXPECT_LE(std::hypot(grain.position[0], grain.position[1]), 12.0);
      EXPECT_LE(grains.line[k > 0 ? k - 1 : 0].position[0], grain.position[0]);
      highest = std::max(highest, grain.position[2]);
      lowest = std::min(lowest, grain.position[2]);
      largest = std::max(largest, grain.radius);
      smallest = std::min(smallest, grain.radius);
    }
    EXPECT_EQ(highest, 0.0);
    EXPECT_GT(lowest, -4.0);
    EXPECT_NEAR(largest, 0.5, 0.005);
    EXPECT_NEAR(smallest, 0.5 * (1.0 - polydispersity), 0.005);
    EXPECT_LT(testing::deepest_overlap(grains, {}), 1e-9);
    // Fewer than the whole deposit of four diameters, more than a single layer. [spheres per square of a diameter]
    const double mean_volume = 0.25 * (2.0 - polydispersity) * (1.0 + (1.0 - polydispersity) * (1.0 - polydispersity));
    const double density = static_cast<double>(grains.size()) / (3.1416 * 144.0) * std::pow(mean_volume, 2.0 / 3.0);
    EXPECT_GT(density, 1.0);
    EXPECT_LT(density, 3.0);
  }
}

TEST(DepositedBed, TheSeedMakesTheBase) {
  const auto first = deposited(6.0, 0.2);
  const auto again = deposited(6.0, 0.2);
  const auto other = deposited(6.0, 0.2, 2);
  ASSERT_EQ(first.size(), again.size());
  std::size_t same = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first.line[k].position, again.line[k].position);
    EXPECT_EQ(first.line[k].radius, again.line[k].radius);
    same += k < other.size() && first.line[k].position == other.line[k].position;
  }
  EXPECT_EQ(same, 0U);
}

// Small spheres that are dropped on it, one after the other until they cover it, all come to rest, and on it: of those
// that fall away from the edge none gets below the lowest sphere of the base.
TEST(DepositedBed, NothingFallsThrough) {
  for (const double polydispersity : {0.0, 0.5}) {
    auto grains = deposited(12.0, polydispersity);
    const auto base = grains.size();
    double lowest = 0.0;
    for (const auto& grain : grains.line) lowest = std::min(lowest, grain.position[2]);
    SphereDepositionSettings settings;
    settings.critical_angle_deg = 0.0;
    settings.drop_radius = 8.0;
    settings.count = 1500;
    settings.draw = [&](std::int64_t k, std::span<DroppedSphere> spheres) {
      for (auto& sphere : spheres) {
        const auto index = static_cast<std::uint64_t>(k++);
        sphere = {{uniform(7, Purpose::release_position, index), uniform(7, Purpose::release_position, index, 1)},
                  0.5 * (1.0 - polydispersity),
                  1.0,
                  0};
      }
    };
    const auto method = make_sphere_deposition(settings);
    method->grains_added(grains);
    Team team(1);
    EXPECT_FALSE(method->advance(grains, 1500.0, team).trouble);
    double deepest = 1.0;
    std::size_t lost = 1500 - (grains.size() - base);
    for (std::size_t k = base; k < grains.size(); ++k) {
      deepest = std::min(deepest, grains.line[k].position[2] - lowest);
    }
    EXPECT_EQ(lost, 0U);
    EXPECT_GT(deepest, 0.0);
  }
}

TEST(DepositedBed, OneNameForDiscsAndSpheres) {
  EXPECT_NE(scene_from_text(text_of("radius = 5.0"), "scene").base.as<DepositedBed>(), nullptr);
  EXPECT_NE(scene_from_text("stop = { time = 1 }\nbase = { kind = 'deposited', half_width = 9.0 }\n"
                            "[[grain]]\nposition = [0.0, 3.0]\n",
                            "scene")
                .base.as<DepositedBase>(),
            nullptr);
}

TEST(DepositedBed, EveryProblemIsOneError) {
  const auto problems = [](const std::string& base, const std::string& more = "") -> std::vector<std::string> {
    try {
      scene_from_text(text_of(base, more), "scene");
    } catch (const InputError& error) {
      return error.problems();
    }
    return {};
  };
  const auto expect = [&](const std::vector<std::string>& found, const std::string& part) {
    ASSERT_EQ(found.size(), 1U) << part;
    EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
  };
  EXPECT_TRUE(problems("radius = 5.0").empty());
  expect(problems("radius = -5.0"), "base.radius = -5: must be > 0");
  expect(problems("radius = 1.9"), "base.radius = 1.9: must be at least two of the largest diameters, 2 [L]");
  expect(problems("radius = 2000.0"), "base.radius = 2000: 7.2e+07 spheres would be dropped; at most 1e+07");
  expect(problems("radius = 5.0", "grains = { polydispersity = 0.6 }\n"),
         "base.kind = \"deposited\": grains may fall through; the smallest diameter, 0.4, must be at least half the "
         "largest, 1 [L]");
  expect(problems("radius = 5.0", "box = { x = 'periodic', half_width = 9.0, y = 'open' }\n"),
         "a periodic box needs another base");
  expect(problems("radius = 5.0", "box = { half_width = 4.0, half_depth = 9.0 }\n"),
         "box.half_width = 4: must be at least base.radius = 5");
  expect(problems("radius = 5.0", "box = { half_width = 9.0, half_depth = 4.0 }\n"),
         "box.half_depth = 4: must be at least base.radius = 5");
  expect(problems("radius = 5.0, roughness = 0.1"), "base.roughness");
}

}  // namespace
}  // namespace repose
