// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/voronoi.hpp"

#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

Grain<2> disc(double x, double y, double radius = 0.5, bool fixed = false) {
  Grain<2> grain;
  grain.position = {{x, y}};
  grain.radius = radius;
  grain.mass = 1.0;
  grain.inverse_mass = fixed ? 0.0 : 1.0;
  return grain;
}

std::vector<bool> all(const Grains<2>& grains) { return std::vector<bool>(grains.size(), true); }

Box<2> periodic(double width) {
  Box<2> box;
  box.periodic = true;
  box.x_min = 0.0;
  box.x_max = width;
  return box;
}

using Outline = std::vector<Vec<2>>;

double area_of(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto& a = outline[k];
    const auto& b = outline[(k + 1) % outline.size()];
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * doubled;
}

/// The part of a convex outline with x . normal < limit.
Outline clipped(const Outline& outline, const Vec<2>& normal, double limit) {
  Outline kept;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto& a = outline[k];
    const auto& b = outline[(k + 1) % outline.size()];
    const double over_a = dot(a, normal) - limit;
    const double over_b = dot(b, normal) - limit;
    if (over_a < 0.0) kept.push_back(a);
    if ((over_a < 0.0) != (over_b < 0.0)) kept.push_back(a + (b - a) * (over_a / (over_a - over_b)));
  }
  return kept;
}

Outline cut_off_polygon(double largest) {
  const double corner = 1.5 * largest / std::cos(std::numbers::pi / 32.0);
  Outline outline;
  for (int k = 0; k < 32; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / 32.0;
    outline.push_back({{corner * std::cos(angle), corner * std::sin(angle)}});
  }
  return outline;
}

/// The cell of grain k about its centre: the cut-off polygon, clipped by every image of every other grain.
Outline by_brute_force(const Grains<2>& grains, const std::vector<bool>& in_heap, const std::vector<FlatWall>& walls,
                       const Box<2>& box, std::size_t k) {
  double largest = 0.0;
  for (std::size_t j = 0; j < grains.size(); ++j)
    if (in_heap[j]) largest = std::max(largest, 2.0 * grains.line[j].radius);
  const auto& own = grains.line[k];
  auto outline = cut_off_polygon(largest);
  const int images = box.periodic ? 8 : 0;
  for (std::size_t j = 0; j < grains.size(); ++j) {
    const auto& other = grains.line[j];
    if (!in_heap[j] && !other.fixed()) continue;
    for (int image = -images; image <= images; ++image) {
      if (j == k && image == 0) continue;
      Vec<2> offset = other.position - own.position;
      if (image != 0) offset[0] += image * box.width();
      outline =
          clipped(outline, offset, 0.5 * (squared(offset) + own.radius * own.radius - other.radius * other.radius));
    }
  }
  for (const auto& wall : walls) outline = clipped(outline, -wall.normal, dot(own.position - wall.point, wall.normal));
  return outline;
}

/// Discs of unequal size near the points of a square lattice. One row in ten is fixed, and some discs overlap.
Grains<2> scattered(int columns, int rows, double spacing, std::uint64_t seed) {
  Grains<2> grains;
  for (int k = 0; k < columns * rows; ++k) {
    const auto index = static_cast<std::uint64_t>(k);
    const auto random = [&](std::uint32_t draw) { return uniform(seed, Purpose::grain_size, index, draw); };
    const double x = spacing * (k % columns + 0.1 + 0.8 * random(0));
    const double y = spacing * (k / columns + 0.1 + 0.8 * random(1));
    grains.add(disc(x, y, 0.3 + 0.2 * random(2), k / columns % 10 == 9), (k * 7919) % (columns * rows));
  }
  return grains;
}

std::vector<FlatWall> floor_and_lid(double height) {
  return {{{{3.0, 0.0}}, {{0.0, 1.0}}}, {{{-1.0, height}}, {{0.0, -1.0}}}};
}

/// Compares areas with brute force; the outline of each cell must have its area.
void expect_brute_force(const Grains<2>& grains, const std::vector<bool>& in_heap, const std::vector<FlatWall>& walls,
                        const Box<2>& box) {
  std::vector<bool> in_heap_by_id;
  for (const auto k : by_id(grains)) in_heap_by_id.push_back(in_heap[k]);
  const auto cells = voronoi({grains, box}, in_heap_by_id, walls, box);
  std::size_t next = 0;
  for (const auto k : by_id(grains)) {
    if (!in_heap[k]) continue;
    ASSERT_LT(next, cells.size());
    const auto& cell = cells[next++];
    ASSERT_EQ(cell.id, grains.id[k]);
    const double area = area_of(by_brute_force(grains, in_heap, walls, box, k));
    EXPECT_NEAR(cell.area, area, 1e-10) << cell.id;
    EXPECT_NEAR(area_of(cell.vertices), area, 1e-10) << cell.id;
    if (area > 0.0) {
      EXPECT_NEAR(cell.solid_fraction * area, std::numbers::pi * squared(grains.line[k].radius), 1e-9);
    }
  }
  EXPECT_EQ(next, cells.size());
}

// A hexagon of area sqrt(3)/2 d^2, filled to pi / sqrt(12).
TEST(Voronoi, TriangularLattice) {
  constexpr double diameter = 0.013;
  Grains<2> grains;
  for (int row = 0; row < 9; ++row)
    for (int k = 0; k < 9; ++k)
      grains.add(disc(diameter * (k + 0.5 * row), diameter * std::sqrt(0.75) * row, 0.5 * diameter), 9 * row + k);
  const auto cells = voronoi({grains, {}}, all(grains), {}, {});
  ASSERT_EQ(cells.size(), 81U);
  for (int row = 1; row < 8; ++row) {
    for (int k = 1; k < 8; ++k) {
      const auto& cell = cells[static_cast<std::size_t>(9 * row + k)];
      EXPECT_NEAR(cell.area / (std::sqrt(0.75) * diameter * diameter), 1.0, 1e-10);
      EXPECT_NEAR(cell.solid_fraction, std::numbers::pi / std::sqrt(12.0), 1e-10);
      EXPECT_TRUE(cell.closed);
      EXPECT_EQ(cell.vertices.size(), 6U);
    }
  }
  EXPECT_FALSE(cells[0].closed);
}

TEST(Voronoi, SquareLatticeInAPeriodicBoxUpToItsFloor) {
  Grains<2> grains;
  for (int row = 0; row < 6; ++row)
    for (int k = 0; k < 8; ++k) grains.add(disc(k + 0.5, row + 0.5), 8 * row + k);
  const auto cells = voronoi({grains, periodic(8.0)}, all(grains), {{{{0.0, 0.0}}, {{0.0, 1.0}}}}, periodic(8.0));
  for (int k = 0; k < 48; ++k) {
    const auto& cell = cells[static_cast<std::size_t>(k)];
    EXPECT_EQ(cell.closed, k < 40) << k;  // all except the top row
    if (k >= 40) continue;
    EXPECT_NEAR(cell.area, 1.0, 1e-10);
    EXPECT_NEAR(cell.solid_fraction, std::numbers::pi / 4.0, 1e-10);
    EXPECT_EQ(cell.vertices.size(), 4U);
  }
}

// The radical line of two touching discs with radii 1 and 0.5 is their common tangent, 1 and 0.5 from the centres.
TEST(Voronoi, RadicalLineOfUnequalDiscs) {
  Grains<2> grains;
  grains.add(disc(2.0, 1.0, 1.0), 0);
  grains.add(disc(2.0 + 1.5, 1.0, 0.5), 1);
  const auto cells = voronoi({grains, {}}, all(grains), {}, {});
  ASSERT_EQ(cells.size(), 2U);
  double right = -1e9;
  for (const auto& vertex : cells[0].vertices) right = std::max(right, vertex[0]);
  double left = 1e9;
  for (const auto& vertex : cells[1].vertices) left = std::min(left, vertex[0]);
  EXPECT_NEAR(right, 3.0, 1e-10);
  EXPECT_NEAR(left, 3.0, 1e-10);
  EXPECT_FALSE(cells[0].closed || cells[1].closed);
}

TEST(Voronoi, LoneGrainHasTheCutOffPolygon) {
  Grains<2> grains;
  grains.add(disc(-7.0, 40.0), 5);
  grains.add(disc(-6.0, 40.0), 6);  // in flight
  const std::vector<bool> heap{true, false};
  const auto cells = voronoi({grains, {}}, heap, {}, {});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].id, 5);
  EXPECT_FALSE(cells[0].closed);
  EXPECT_EQ(cells[0].vertices.size(), 32U);
  EXPECT_NEAR(cells[0].area, 32.0 * 2.25 * std::tan(std::numbers::pi / 32.0), 1e-10);
  for (const auto& vertex : cells[0].vertices)
    EXPECT_NEAR(magnitude(vertex - grains.line[0].position), 1.5 / std::cos(std::numbers::pi / 32.0), 1e-10);
}

TEST(Voronoi, WallsCutAndCloseCells) {
  Grains<2> grains;
  grains.add(disc(0.0, 0.0), 0);
  const double diagonal = std::sqrt(0.5);
  // A corner of two sloping walls, 0.6 and 0.5 from the centre, below a lid at 0.7.
  std::vector<FlatWall> walls{{{{0.0, -0.6 / diagonal}}, {{diagonal, diagonal}}},
                              {{{0.0, -0.5 / diagonal}}, {{-diagonal, diagonal}}}};
  const auto open = voronoi({grains, {}}, all(grains), walls, {});
  EXPECT_FALSE(open[0].closed);
  walls.push_back({{{0.0, 0.4}}, {{0.0, -1.0}}});
  const auto shut = voronoi({grains, {}}, all(grains), walls, {});
  EXPECT_TRUE(shut[0].closed);
  ASSERT_EQ(shut[0].vertices.size(), 3U);
  const double depth = 0.4 + (0.6 + 0.5) * diagonal;  // of the right-angled corner below the lid
  EXPECT_NEAR(shut[0].area, depth * depth, 1e-10);
}

TEST(Voronoi, FixedGrainsBoundCellsAndHaveNone) {
  Grains<2> grains;
  for (int k = 0; k < 25; ++k) grains.add(disc(k % 5, k / 5, 0.5, k != 12), k);
  std::vector<bool> heap(25, false);
  heap[12] = true;
  const auto cells = voronoi({grains, {}}, heap, {}, {});
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_TRUE(cells[0].closed);
  EXPECT_NEAR(cells[0].area, 1.0, 1e-10);
}

TEST(Voronoi, NoneWithoutGrains) {
  EXPECT_TRUE(voronoi({}, {}, {}, {}).empty());
  Grains<2> grains;
  grains.add(disc(0.0, 0.0, 0.5, true), 0);
  EXPECT_TRUE(voronoi({grains, {}}, {false}, {}, {}).empty());
}

// At every point of the small disc, a larger one has the smaller power.
TEST(Voronoi, BuriedDiscHasAnEmptyCell) {
  Grains<2> grains;
  grains.add(disc(0.0, 0.0, 1.0), 0);
  grains.add(disc(0.1, 0.0, 0.1), 1);
  for (int k = 0; k < 6; ++k) {
    const double angle = std::numbers::pi * k / 3.0;
    grains.add(disc(0.6 * std::cos(angle), 0.6 * std::sin(angle), 1.0), 2 + k);
  }
  const auto cells = voronoi({grains, {}}, all(grains), {}, {});
  EXPECT_EQ(cells[1].area, 0.0);
  EXPECT_TRUE(cells[1].vertices.empty());
  EXPECT_TRUE(std::isnan(cells[1].solid_fraction));
}

// Between floor and lid the cells of dense random discs fill the box: their areas sum to that of the box.
TEST(Voronoi, CellsFillAPeriodicBox) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto grains = scattered(15, 12, 0.8, seed);
    for (std::size_t k = 0; k < grains.size(); k += 5) grains.line[k].position[0] -= 5.0;  // unwrapped positions too
    const auto cells = voronoi({grains, periodic(15 * 0.8)}, all(grains), floor_and_lid(12 * 0.8), periodic(15 * 0.8));
    double sum = 0.0;
    for (const auto& cell : cells) {
      sum += cell.area;
      EXPECT_TRUE(cell.closed);
    }
    EXPECT_NEAR(sum / (15.0 * 0.8 * 12.0 * 0.8), 1.0, 1e-10);
  }
}

TEST(Voronoi, AgreesWithBruteForce) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto grains = scattered(14, 11, 0.9, seed);
    std::vector<bool> heap(grains.size());
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const bool flies = uniform(seed, Purpose::release_position, k) < 0.3;  // leaves holes wider than the cut-off
      heap[k] = !grains.line[k].fixed() && !flies;
    }
    expect_brute_force(grains, heap, {}, {});
    expect_brute_force(grains, heap, floor_and_lid(8.0), periodic(14 * 0.9));
  }
}

// In a box narrower than the reach, farther images, and those of the grain itself, bound its cell.
TEST(Voronoi, NarrowPeriodicBox) {
  for (const int columns : {1, 2, 3, 5}) {
    const auto grains = scattered(columns, 9, 0.9, 3);
    expect_brute_force(grains, all(grains), floor_and_lid(9 * 0.9), periodic(columns * 0.9));
  }
}

// A fixed disc far larger than the grains bounds cells from beyond their own reach.
TEST(Voronoi, LargeFixedNeighbour) {
  auto grains = scattered(12, 8, 0.9, 11);
  grains.add(disc(5.0, -20.0, 20.0, true), 1000);
  auto heap = all(grains);
  heap.back() = false;
  expect_brute_force(grains, heap, {}, {});
}

}  // namespace
}  // namespace repose
