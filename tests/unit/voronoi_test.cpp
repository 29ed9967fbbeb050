// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/voronoi.hpp"

#include "repose/core/random.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

std::vector<bool> all_of(const Grains<2>& grains) { return std::vector<bool>(grains.size(), true); }

double polygon_area(const std::vector<Vec<2>>& v) {
  double twice = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const auto& a = v[k];
    const auto& b = v[(k + 1) % v.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

/// Keeps the part of a convex polygon where dot(normal, p) <= limit.
std::vector<Vec<2>> clipped(const std::vector<Vec<2>>& polygon, const Vec<2>& normal, double limit) {
  std::vector<Vec<2>> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& a = polygon[k];
    const auto& b = polygon[(k + 1) % polygon.size()];
    const double over_a = dot(normal, a) - limit;
    const double over_b = dot(normal, b) - limit;
    if (over_a <= 0.0) kept.push_back(a);
    if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
      kept.push_back(a + (b - a) * (over_a / (over_a - over_b)));
    }
  }
  return kept;
}

/// The cell by its definition: the cut-off polygon, clipped by the radical plane of every other grain.
double area_by_brute_force(const Grains<2>& grains, std::size_t k, const Box<2>& box, double largest) {
  std::vector<Vec<2>> polygon;
  for (int side = 0; side < 32; ++side) {
    const double angle = 2.0 * std::numbers::pi * (side + 0.5) / 32.0;
    const double distance = 1.5 * largest / std::cos(std::numbers::pi / 32.0);
    polygon.push_back({{distance * std::cos(angle), distance * std::sin(angle)}});
  }
  const auto& self = grains.line[k];
  for (std::size_t m = 0; m < grains.size(); ++m) {
    if (m == k) continue;
    const Vec<2> d = separation(grains.line[m].position, self.position, box);
    const double power = dot(d, d) + self.radius * self.radius - grains.line[m].radius * grains.line[m].radius;
    polygon = clipped(polygon, d, 0.5 * power);
  }
  return polygon_area(polygon);
}

TEST(Voronoi, TriangularLattice) {
  Grains<2> grains;
  for (int row = -5; row <= 5; ++row) {
    for (int column = -5; column <= 5; ++column) {
      grains.add(unit_disc(column + 0.5 * (row & 1), row * std::sqrt(3.0) / 2.0),
                 static_cast<std::int64_t>(grains.size()));
    }
  }
  const auto cells = voronoi(grains, all_of(grains), {}, {});
  ASSERT_EQ(cells.size(), grains.size());
  const auto& middle = cells[5 * 11 + 5];
  EXPECT_TRUE(middle.closed);
  EXPECT_NEAR(middle.area, std::sqrt(3.0) / 2.0, 1e-9);
  EXPECT_NEAR(middle.solid_fraction, std::numbers::pi / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(polygon_area(middle.vertices), middle.area, 1e-9);
  EXPECT_FALSE(cells.front().closed);
}

TEST(Voronoi, SquareLattice) {
  Grains<2> grains;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) grains.add(unit_disc(column, row), 5 * row + column);
  }
  const auto cells = voronoi(grains, all_of(grains), {}, {});
  EXPECT_TRUE(cells[12].closed);
  EXPECT_NEAR(cells[12].area, 1.0, 1e-9);
  EXPECT_NEAR(cells[12].solid_fraction, std::numbers::pi / 4.0, 1e-9);
}

// The radical line of discs of radii a and b at a distance d lies (d^2 + a^2 - b^2)/(2 d) from the first centre.
TEST(Voronoi, TwoDiscsOfUnequalSize) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.0), 0);
  auto large = unit_disc(1.6, 0.0);
  large.radius = 1.0;
  grains.add(large, 1);
  const auto cells = voronoi(grains, all_of(grains), {}, {});
  const auto right_end = [](const auto& cell) {
    double most = -1e9;
    for (const auto& vertex : cell.vertices) most = std::max(most, vertex[0]);
    return most;
  };
  EXPECT_NEAR(right_end(cells[0]), (1.6 * 1.6 + 0.25 - 1.0) / 3.2, 1e-10);
  EXPECT_FALSE(cells[0].closed);
}

// In a dense periodic packing the cells share the strip out; each is also what its definition says.
TEST(Voronoi, CellsCoverAPeriodicBoxAndAgreeWithBruteForce) {
  Box<2> box;
  box.periodic = true;
  box.x_min = 0.0;
  box.x_max = 12.0;
  Grains<2> grains;
  for (int k = 0; k < 400; ++k) {
    const auto draw = [&](std::uint32_t n) { return uniform(3, Purpose::grain_size, static_cast<std::uint64_t>(k), n); };
    auto grain = unit_disc(12.0 * draw(0), 12.0 * draw(1));
    grain.radius = 0.3 + 0.2 * draw(2);
    grains.add(grain, k);
  }
  const std::vector<Edge> edges = {{{{0.0, 0.0}}, {{0.0, 1.0}}}, {{{0.0, 12.0}}, {{0.0, -1.0}}}};
  const auto cells = voronoi(grains, all_of(grains), edges, box);
  double all = 0.0;
  for (const auto& cell : cells) all += cell.area;
  EXPECT_NEAR(all, 144.0, 1e-7);
  double largest = 0.0;
  for (const auto& grain : grains.line) largest = std::max(largest, 2.0 * grain.radius);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double y = grains.line[k].position[1];
    if (y < 2.0 || y > 10.0) continue;  // beyond the reach of the edges
    ++compared;
    EXPECT_NEAR(cells[k].area, area_by_brute_force(grains, k, box, largest), 1e-9) << k;
  }
  EXPECT_GT(compared, 200U);
}

TEST(Voronoi, ALoneGrainHasTheCutOffPolygon) {
  Grains<2> grains;
  grains.add(unit_disc(3.0, 4.0), 9);
  const auto cells = voronoi(grains, {true}, {}, {});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].id, 9);
  EXPECT_FALSE(cells[0].closed);
  EXPECT_EQ(cells[0].vertices.size(), 32U);
  EXPECT_NEAR(cells[0].area, 32.0 * 1.5 * 1.5 * std::tan(std::numbers::pi / 32.0), 1e-9);
}

TEST(Voronoi, AnEdgeCutsAndFixedGrainsBoundButHaveNoCell) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.5), 0);
  grains.add(unit_disc(0.0, 1.5, true), 1);
  grains.add(unit_disc(0.0, 2.5), 2);  // in flight: does not count
  const std::vector<Edge> floor = {{{{0.0, 0.0}}, {{0.0, 1.0}}}};
  const auto cells = voronoi(grains, {true, false, false}, floor, {});
  ASSERT_EQ(cells.size(), 1U);
  const auto [low, high] = std::minmax_element(cells[0].vertices.begin(), cells[0].vertices.end(),
                                               [](const auto& a, const auto& b) { return a[1] < b[1]; });
  EXPECT_NEAR((*low)[1], 0.0, 1e-10);
  EXPECT_NEAR((*high)[1], 1.0, 1e-10);
}

TEST(Voronoi, NothingThere) {
  const Grains<2> none;
  EXPECT_TRUE(voronoi(none, {}, {}, {}).empty());
}

}  // namespace
}  // namespace repose
