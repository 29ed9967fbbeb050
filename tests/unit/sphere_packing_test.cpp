// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_packing.hpp"

#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double pi = std::numbers::pi;

Spheres spheres_at(const std::vector<Vec<3>>& centres) {
  Spheres spheres;
  for (const auto& centre : centres) spheres.add(centre, 0.5);
  return spheres;
}

SpherePacking measure(const Spheres& spheres, const Box<3>& box, const PackingCore& core) {
  Grains<3> grains;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    grains.add(unit_sphere(spheres.position[k]), static_cast<std::int64_t>(k));
  }
  const OrderedGrains<3> ordered(grains, box);
  const auto cells = sphere_cells(ordered, std::vector<bool>(grains.size(), true), {}, box);
  const auto graph = contact_graph(spheres, box, 1e-9);
  const std::vector<std::uint8_t> on_walls(spheres.size(), 0);
  return measure_sphere_packing(spheres, cells, graph, on_walls, rattlers(spheres, graph, on_walls), core);
}

TEST(SpherePacking, Lattices) {
  const double side = 3.0 * std::numbers::sqrt2;
  const auto dense = measure(spheres_at(fcc_centres(3, 4)), level_periodic_box(side, side),
                             {.low = 1.0, .high = 4.5, .axis = {{0.5 * side, 0.5 * side}}});
  EXPECT_EQ(dense.spheres, 90U);  // the layers 0.707 apart from 1.414 to 4.243
  EXPECT_EQ(dense.closed, 90U);
  EXPECT_NEAR(dense.solid_fraction.mean, pi / std::sqrt(18.0), 1e-9);
  EXPECT_NEAR(dense.coordination.mean, 12.0, 1e-12);
  EXPECT_NEAR(dense.coordination.error, 0.0, 1e-12);
  EXPECT_EQ(dense.connectivity[12], 1.0);
  EXPECT_NEAR(dense.without_rattlers.mean, 12.0, 1e-12);
  EXPECT_EQ(dense.rattlers, 0.0);

  std::vector<Vec<3>> centres;
  for (int k = 0; k < 64; ++k) centres.push_back({{k % 4 + 0.5, k / 4 % 4 + 0.5, k / 16 + 0.5}});
  const auto cubic = measure(spheres_at(centres), level_periodic_box(4.0, 4.0), {.low = 1.0, .high = 3.0});
  EXPECT_EQ(cubic.spheres, 32U);
  EXPECT_NEAR(cubic.solid_fraction.mean, pi / 6.0, 1e-9);
  EXPECT_NEAR(cubic.coordination.mean, 6.0, 1e-12);
  EXPECT_EQ(cubic.connectivity[6], 1.0);
}

// The contact graph against all pairs, with every combination of periodic axes. Boxes wider than two diameters, down to
// two cells of the search.
TEST(SpherePacking, ContactGraphAgainstAllPairs) {
  for (const double width : {2.3, 3.5, 9.0}) {
    for (int wraps = 0; wraps < 4; ++wraps) {
      auto box = level_periodic_box(width, 2.0 * width);
      box.periodic = wraps % 2 == 1;
      box.periodic_y = wraps / 2 == 1;
      Spheres spheres;
      for (std::uint64_t k = 0; k < 200; ++k) {
        spheres.add({{width * random_number(k, 0), 2.0 * width * random_number(k, 1), 4.0 * random_number(k, 2)}},
                    0.25 + 0.25 * random_number(k, 3));
      }
      const auto graph = contact_graph(spheres, box, 0.1);
      ContactGraph all;
      all.start.push_back(0);
      for (std::size_t i = 0; i < spheres.size(); ++i) {
        for (std::size_t j = 0; j < spheres.size(); ++j) {
          if (i != j && touch(spheres, box, 0.1, i, j)) all.neighbour.push_back(static_cast<std::uint32_t>(j));
        }
        all.start.push_back(static_cast<std::uint32_t>(all.neighbour.size()));
      }
      EXPECT_GT(graph.contacts(), 30U);
      EXPECT_EQ(graph.start, all.start);
      EXPECT_EQ(graph.neighbour, all.neighbour) << width << " " << wraps;
    }
  }
}

// A sphere on three base spheres rests, one on two is a rattler; walls count.
TEST(SpherePacking, Rattlers) {
  Spheres spheres;
  const double height = std::sqrt(2.0 / 3.0);
  for (int k = 0; k < 3; ++k) {
    const double turn = 2.0 * pi * k / 3.0;
    spheres.add({{std::cos(turn) / std::sqrt(3.0), std::sin(turn) / std::sqrt(3.0), 0.0}}, 0.5, true);
  }
  spheres.add({{0.0, 0.0, height}}, 0.5);
  spheres.add({{5.0, 0.0, 0.0}}, 0.5, true);
  spheres.add({{6.0, 0.0, 0.0}}, 0.5, true);
  spheres.add({{5.5, 0.0, std::sqrt(0.75)}}, 0.5);
  const Box<3> box;
  const auto graph = contact_graph(spheres, box, 1e-9);
  PackingWalls walls;
  EXPECT_EQ(rattlers(spheres, graph, wall_contacts(spheres, walls, 1e-9)),
            (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1}));
  walls.back = 0.5;
  EXPECT_EQ(wall_contacts(spheres, walls, 1e-9)[6], 1);
  EXPECT_EQ(rattlers(spheres, graph, wall_contacts(spheres, walls, 1e-9))[6], 0);
}

TEST(SpherePacking, VolumeBelowALevel) {
  EXPECT_NEAR(sphere_volume_below(2.0, 2.0), 4.0 / 3.0 * pi * 8.0, 1e-13);
  EXPECT_NEAR(sphere_volume_below(2.0, 0.0), 2.0 / 3.0 * pi * 8.0, 1e-13);
  EXPECT_EQ(sphere_volume_below(2.0, -3.0), 0.0);
  EXPECT_NEAR(sphere_volume_below(1.0, 0.5), pi * (2.0 / 3.0 + 0.5 - 0.125 / 3.0), 1e-14);
}

// A sphere on the axis of the core: the volume within the radius s is 4/3 pi (1 - (1 - s^2)^1.5). Cut by a level plane
// through its centre, the sum is exact. Tolerance: a hundredth of a sphere in a ring.
TEST(SpherePacking, SolidFractionByRadius) {
  Spheres spheres;
  spheres.add({{2.0, 1.0, 0.0}}, 1.0);
  const PackingCore core{.low = 0.0, .high = 3.0, .axis = {{2.0, 1.0}}, .radius = 2.0};
  const auto profile = radial_solid_fraction(spheres, core, 0.25);
  ASSERT_EQ(profile.value.size(), 8U);
  double sum = 0.0;
  double inner = 0.0;
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(profile.radius[k], 0.25 * static_cast<double>(k) + 0.125, 1e-12);
    const double edge = std::min(1.0, 0.25 * static_cast<double>(k + 1));
    const double within = 2.0 / 3.0 * pi * (1.0 - std::pow(1.0 - edge * edge, 1.5));
    const double volume = profile.value[k] * 3.0 * pi * 0.25 * 2.0 * profile.radius[k];
    EXPECT_NEAR(volume, within - inner, 0.01 * 2.0 / 3.0 * pi) << k;
    inner = within;
    sum += volume;
  }
  EXPECT_NEAR(sum, 2.0 / 3.0 * pi, 1e-12);
}

TEST(SpherePacking, UsualCore) {
  Spheres spheres;
  spheres.add({{0.0, 0.0, 100.0}}, 0.5, true);
  for (int k = 1; k <= 9; ++k) spheres.add({{0.0, 0.0, 2.0 + k}}, 0.5);
  const auto core = usual_core(spheres, 2.0);
  EXPECT_NEAR(core.low, 4.0, 1e-12);
  EXPECT_NEAR(core.high, 9.0, 1e-12);
  EXPECT_TRUE(core.holds({{50.0, 0.0, 4.5}}));
  EXPECT_FALSE(core.holds({{0.0, 0.0, 3.5}}));
}

}  // namespace
}  // namespace repose
