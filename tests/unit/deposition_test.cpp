// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/deposition.hpp"

#include "repose/analysis/packing.hpp"
#include "repose/analysis/sticking_rule.hpp"
#include "repose/core/random.hpp"
#include "repose/methods/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace repose {
namespace {

/// Discs of diameters 1 - spread to 1 on a contiguous row of `width` discs of diameter 1, centres at height 0.
struct Packer {
  int width = 16;
  std::int64_t count = 400;
  double angle_deg = 50.0;
  double spread = 0.0;
  bool periodic = true;
  bool flat = false;  // no base discs, the floor at height 0
  bool snapped = false;
  std::uint64_t seed = 1;

  DepositionSettings settings() const {
    DepositionSettings s;
    s.critical_angle_deg = angle_deg;
    s.box.periodic = periodic;
    s.box.x_min = 0.0;
    s.box.x_max = width;
    s.floor = flat ? 0.0 : -0.5;
    s.smallest_radius = 0.5 * (1.0 - spread);
    s.largest_radius = 0.5;
    s.snapped = snapped;
    s.count = count;
    s.draw = [seed = seed, spread = spread](std::int64_t k, std::span<DroppedDisc> discs) {
      for (auto& disc : discs) {
        const auto index = static_cast<std::uint64_t>(k++);
        disc.place = uniform(seed, Purpose::release_position, index);
        disc.radius = 0.5 * (1.0 - spread * uniform(seed, Purpose::grain_size, index));
        disc.mass = disc.radius * disc.radius * 4.0;
      }
    };
    return s;
  }

  Grains<2> pack(bool brute_force = false) const {
    Grains<2> grains;
    for (int k = 0; k < width && !flat; ++k) {
      Grain<2> fixed;
      fixed.radius = 0.5;
      fixed.mass = 1.0;
      fixed.position = Vec<2>{{k + 0.5, 0.0}};
      grains.add(fixed, k, true);
    }
    const auto method = brute_force ? make_deposition_by_brute_force(settings()) : make_deposition(settings());
    method->grains_added(grains);
    Team team(1);
    EXPECT_FALSE(method->advance(grains, static_cast<double>(count), team).trouble);
    EXPECT_TRUE(method->complete());
    return grains;
  }

  PackingWalls walls() const {
    PackingWalls walls;
    if (flat) walls.floor = 0.0;
    if (!periodic) walls.left = 0.0;
    if (!periodic) walls.right = width;
    return walls;
  }

  Packing measured() const {
    PackingOptions options;
    options.walls = walls();
    if (flat) options.slab.base_height = 0.5;
    const auto grains = pack();
    return analyse_packing(discs_of({grains, settings().box}), settings().box, options).packing.value();
  }
};

// Both searches find the same touches, so their packings are the same to the bit.
TEST(Deposition, ColumnsEqualBruteForce) {
  for (const double spread : {0.0, 0.3, 0.85}) {
    for (const double angle : {0.0, 5.0, 30.0, 50.0, 85.0, 90.0}) {
      for (const int kind : {0, 1, 2}) {
        const Packer packer{.width = 9,
                            .count = 250,
                            .angle_deg = angle,
                            .spread = spread,
                            .periodic = kind != 1,
                            .flat = kind == 2,
                            .seed = 7};
        const auto fast = packer.pack();
        const auto slow = packer.pack(true);
        ASSERT_EQ(fast.size(), slow.size());
        for (std::size_t k = 0; k < fast.size(); ++k) {
          ASSERT_EQ(fast.line[k].position, slow.line[k].position)
              << "disc " << k << " spread " << spread << " angle " << angle << " kind " << kind;
        }
      }
    }
  }
}

// Every disc rests by the rule, checked by independent code, and no overlap is larger than rounding.
TEST(Deposition, EveryDiscRestsWithoutOverlap) {
  for (const double spread : {0.0, 0.3, 0.85}) {
    for (const double angle : {0.0, 5.0, 30.0, 50.0, 75.0, 90.0}) {
      for (const int kind : {0, 1, 2}) {
        const Packer packer{.width = 20,
                            .count = 3000,
                            .angle_deg = angle,
                            .spread = spread,
                            .periodic = kind != 1,
                            .flat = kind == 2,
                            .seed = 3};
        const auto grains = packer.pack();
        const auto box = packer.settings().box;
        const auto discs = discs_of({grains, box});
        constexpr double gap = 1e-9;
        const auto graph = contact_graph(discs, box, gap);
        const auto breaks = breaks_sticking_rule(discs, box, graph, packer.walls(), gap, angle);
        EXPECT_EQ(std::count(breaks.begin(), breaks.end(), 1), 0) << spread << " " << angle << " " << kind;
        EXPECT_LT(deepest_overlap(discs, box, graph), 1e-12) << spread << " " << angle << " " << kind;
      }
    }
  }
}

// The check finds discs that break the rule: one in the air, one on a slope, one below its only support.
TEST(StickingRule, FindsWhatDoesNotRest) {
  Box<2> box;
  box.x_min = -5.0;
  box.x_max = 5.0;
  Discs discs;
  discs.add({{0.0, 0.0}}, 0.5, true);
  const auto at = [&](double degrees, double from_y = 0.0) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return Vec<2>{{std::sin(angle), from_y + std::cos(angle)}};
  };
  discs.add(at(40.0), 0.5);
  discs.add(at(-95.0), 0.5);
  discs.add({{3.0, 3.0}}, 0.5);
  const auto broken = [&](double critical) {
    return breaks_sticking_rule(discs, box, contact_graph(discs, box, 1e-9), {}, 1e-9, critical);
  };
  EXPECT_EQ(broken(41.0), (std::vector<std::uint8_t>{0, 0, 1, 1}));
  EXPECT_EQ(broken(39.0), (std::vector<std::uint8_t>{0, 1, 1, 1}));
  EXPECT_EQ(broken(90.0), (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

// Steepest descent on a contiguous row, with snapped positions, gives exactly the triangular packing, pi / (2 sqrt 3) =
// 0.9069. The slab cuts layers, so its solid fraction is off by up to one layer in 31; contact directions are exact.
TEST(Deposition, SteepestDescentIsTriangular) {
  const auto packing = Packer{.width = 32, .count = 1000, .angle_deg = 0.0, .snapped = true}.measured();
  EXPECT_NEAR(packing.solid_fraction.mean, std::numbers::pi / (2.0 * std::sqrt(3.0)), 5e-4);
  EXPECT_EQ(packing.coordination.mean.mean, 6.0);
}

// The mean of 30 packings of the paper's size, seeds 1-30, against an independent code: 0.374 at 90 deg, 0.446 +- 0.004
// at 50 deg. The scatter of one packing is about 0.02, that of the mean 0.004.
TEST(Deposition, SolidFractionsOfThePaperSize) {
  const auto mean = [](double angle) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      sum += Packer{.width = 32, .count = 1000, .angle_deg = angle, .seed = seed}.measured().solid_fraction.mean;
    }
    return sum / 30.0;
  };
  EXPECT_NEAR(mean(90.0), 0.374, 0.01);
  EXPECT_NEAR(mean(50.0), 0.446, 0.012);
}

// Sticking at first touch makes a forest with one contact per disc. z is 2, except for discs that a later disc touches
// by chance (none here).
TEST(Deposition, SticksOnceAtNinetyDegrees) {
  const Packer packer{.width = 100, .count = 20000, .angle_deg = 90.0};
  const auto grains = packer.pack();
  const auto graph = contact_graph(discs_of({grains, packer.settings().box}), packer.settings().box, 1e-9);
  EXPECT_EQ(graph.contacts(), 20000U + 100U);  // the second term: those of the contiguous row
  EXPECT_NEAR(packer.measured().coordination.mean.mean, 2.0, 0.02);
}

// Resuming in the middle is tested with the program (tests/cli/test_deposition.py).
TEST(Deposition, StepsAreDiscs) {
  const Packer packer{.count = 10};
  Grains<2> grains;
  auto settings = packer.settings();
  settings.floor = 0.0;
  const auto method = make_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  EXPECT_EQ(method->advance(grains, 4.0, team).steps, 4);
  EXPECT_EQ(method->made(), 4);
  EXPECT_FALSE(method->complete());
  const auto rest = method->advance(grains, 100.0, team);
  EXPECT_EQ(rest.steps, 6);
  EXPECT_EQ(rest.time, 10.0);
  EXPECT_TRUE(method->complete());
  EXPECT_EQ(grains.size(), 10U);
}

// The contacts of a packing come in blocks, none of them empty or large, in the order of the list.
TEST(Deposition, ContactsComeInBlocks) {
  const auto settings = Packer{.width = 100, .count = 70'000, .angle_deg = 90.0}.settings();
  Grains<2> grains;
  grains.add({.position = Vec<2>{{50.0, 0.0}}, .radius = 0.5, .mass = 1.0}, 0, true);
  const auto method = make_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  ASSERT_FALSE(method->advance(grains, 1e9, team).trouble);
  const auto list = method->contacts(grains).list;
  const auto blocks = contacts_of_supports(grains, *method->supports(), settings.box);
  EXPECT_EQ(blocks.size, list.size());
  EXPECT_GT(list.size(), 65536U);
  std::size_t seen = 0;
  blocks.for_each([&](const auto& block) {
    ASSERT_FALSE(block.empty());
    ASSERT_LE(seen + block.size(), list.size());
    EXPECT_LE(block.size(), 65536U);
    for (const auto& contact : block) {
      EXPECT_EQ(contact.first, list[seen].first);
      EXPECT_EQ(contact.second, list[seen].second);
      EXPECT_NEAR(contact.overlap, 0.0, 1e-11);
      ++seen;
    }
  });
  EXPECT_EQ(seen, list.size());
}

// With nothing below, a disc that falls without end is reported as trouble, not an endless loop.
TEST(Deposition, FallWithoutEndIsTrouble) {
  auto settings = Packer{}.settings();
  settings.floor = -std::numeric_limits<double>::infinity();
  Grains<2> grains;
  const auto method = make_deposition(settings);
  method->grains_added(grains);
  Team team(1);
  const auto report = method->advance(grains, 1.0, team);
  EXPECT_TRUE(report.trouble);
  EXPECT_EQ(report.steps, 0);
}

}  // namespace
}  // namespace repose
