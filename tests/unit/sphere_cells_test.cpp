// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_cells.hpp"

#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

using namespace packs;

constexpr double pi = std::numbers::pi;

Grains<3> spheres_at(const std::vector<Vec<3>>& centres) {
  Grains<3> grains;
  for (const auto& centre : centres) grains.add(unit_sphere(centre), static_cast<std::int64_t>(grains.size()));
  return grains;
}

std::vector<SphereCell> cells_of(const Grains<3>& grains, const CellWalls& walls, const Box<3>& box,
                                 double cut_off = 1.5) {
  const OrderedGrains<3> ordered(grains, box);
  std::vector<bool> in_heap;
  for (const auto& grain : ordered->line) in_heap.push_back(!grain.fixed());
  return sphere_cells(ordered, in_heap, walls, box, cut_off);
}

CellWalls between_levels(double low, double high) {
  CellWalls walls;
  walls.planes.push_back({{{0.0, 0.0, low}}, {{0.0, 0.0, 1.0}}});
  walls.planes.push_back({{{0.0, 0.0, high}}, {{0.0, 0.0, -1.0}}});
  return walls;
}

double sum_of(const std::vector<SphereCell>& cells) {
  double sum = 0.0;
  for (const auto& cell : cells) sum += cell.volume;
  return sum;
}

// Face-centred cubic: cells of volume 1/sqrt(2), solid fraction pi/sqrt(18), except at the open faces of the slab.
TEST(SphereCells, FaceCentredCubic) {
  constexpr int cells = 3;
  const double side = cells * std::numbers::sqrt2;
  const auto found = cells_of(spheres_at(fcc_centres(cells, 4)), {}, level_periodic_box(side, side));
  ASSERT_EQ(found.size(), 4U * cells * cells * 4U);
  const auto centres = fcc_centres(cells, 4);
  std::size_t inside = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].id, static_cast<std::int64_t>(k));
    EXPECT_EQ(found[k].place, k);
    const bool at_face = centres[k][2] < 0.1 || centres[k][2] > 3.5 * std::numbers::sqrt2 - 0.1;
    EXPECT_EQ(found[k].closed, !at_face);
    if (at_face) continue;
    ++inside;
    EXPECT_NEAR(found[k].volume, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(found[k].solid_fraction, pi / std::sqrt(18.0), 1e-9);
  }
  EXPECT_EQ(inside, 4U * cells * cells * 3U);
}

// Simple cubic between planes: every cell is a cube, also of a single sphere that is its own neighbour.
TEST(SphereCells, SimpleCubic) {
  for (const int count : {1, 2, 4}) {
    std::vector<Vec<3>> centres;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        for (int k = 0; k < 3; ++k) centres.push_back({{i + 0.5, j + 0.5, k + 0.5}});
      }
    }
    const auto found = cells_of(spheres_at(centres), between_levels(0.0, 3.0), level_periodic_box(count, count));
    ASSERT_EQ(found.size(), centres.size());
    for (const auto& cell : found) {
      EXPECT_NEAR(cell.volume, 1.0, 1e-9);
      EXPECT_NEAR(cell.solid_fraction, pi / 6.0, 1e-9);
      EXPECT_TRUE(cell.closed);
    }
  }
}

// Radical cells of two spheres of different size: the plane lies (d^2 + r_1^2 - r_2^2)/(2 d) from the first.
TEST(SphereCells, RadicalPlane) {
  Grains<3> grains;
  grains.add(unit_sphere({{0.5, 0.5, 1.0}}, false, 0.7), 0);
  grains.add(unit_sphere({{0.5, 0.5, 2.0}}, false, 0.3), 1);
  const auto found = cells_of(grains, between_levels(0.0, 3.0), level_periodic_box(1.0, 1.0));
  EXPECT_NEAR(found[0].volume, 1.0 + 0.5 * (1.0 + 0.49 - 0.09), 1e-9);
  EXPECT_NEAR(found[1].volume, 2.0 - 0.5 * (1.0 + 0.49 - 0.09), 1e-9);
}

// Random spheres of sizes from 0.5 to 1 fill a box, periodic or with walls, without gaps: the volumes sum to that of
// the box. So do those in a cylinder, but for the slivers at its wall: at most (1/8)^2/2R thick, a third of that on
// average.
TEST(SphereCells, VolumesFillTheSpace) {
  Grains<3> grains;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const Vec<3> at{{5.0 * random_number(k, 0), 6.0 * random_number(k, 1), 7.0 * random_number(k, 2)}};
    grains.add(unit_sphere(at, false, 0.25 + 0.25 * random_number(k, 3)), static_cast<std::int64_t>(k));
  }
  const double cut_off = 6.0;  // beyond every cell
  const auto levels = between_levels(0.0, 7.0);
  const auto periodic = cells_of(grains, levels, level_periodic_box(5.0, 6.0), cut_off);
  EXPECT_NEAR(sum_of(periodic), 210.0, 1e-7);
  const auto is_closed = [](const auto& cell) { return cell.closed || cell.volume == 0.0; };  // some are buried
  EXPECT_TRUE(std::all_of(periodic.begin(), periodic.end(), is_closed));
  auto walls = levels;
  walls.planes.push_back({{{0.0, 0.0, 0.0}}, {{1.0, 0.0, 0.0}}});
  walls.planes.push_back({{{5.0, 0.0, 0.0}}, {{-1.0, 0.0, 0.0}}});
  auto y_periodic = level_periodic_box(5.0, 6.0);
  y_periodic.periodic = false;
  const auto between = cells_of(grains, walls, y_periodic, cut_off);
  EXPECT_NEAR(sum_of(between), 210.0, 1e-7);

  Grains<3> in_pipe;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const double turn = 2.0 * pi * random_number(k, 4);
    const double radius = 2.0 * std::sqrt(random_number(k, 5));
    in_pipe.add(unit_sphere({{1.0 + radius * std::cos(turn), radius * std::sin(turn), 7.0 * random_number(k, 6)}}),
                static_cast<std::int64_t>(k));
  }
  auto pipe = levels;
  pipe.cylinders.push_back({{{1.0, 0.0, 3.0}}, {{0.0, 0.0, 1.0}}, 2.0});
  const auto in_cylinder = cells_of(in_pipe, pipe, {}, cut_off);
  const double volume = pi * 4.0 * 7.0;
  EXPECT_GT(sum_of(in_cylinder), volume);
  EXPECT_LT(sum_of(in_cylinder), volume + 2.0 * pi * 2.0 * 7.0 / (64.0 * 4.0));
  EXPECT_TRUE(std::all_of(in_cylinder.begin(), in_cylinder.end(), is_closed));
}

// A sphere alone has the polyhedron of the cut-off, between its inscribed sphere and 1.3 times that.
TEST(SphereCells, CutOff) {
  const auto alone = cells_of(spheres_at({{{0.0, 0.0, 0.0}}}), {}, {});
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_FALSE(alone[0].closed);
  const double inscribed = 4.0 / 3.0 * pi * 1.5 * 1.5 * 1.5;
  EXPECT_GT(alone[0].volume, inscribed);
  EXPECT_LT(alone[0].volume, 1.3 * inscribed);
  EXPECT_TRUE(cells_of({}, {}, {}).empty());
}

// Fixed grains bound cells and have none; grains in flight do neither. The memory order does not matter, to the bit.
TEST(SphereCells, FixedAndFlyingGrains) {
  Grains<3> grains;
  for (std::uint64_t k = 0; k < 60; ++k) {
    const Vec<3> at{{3.0 * random_number(k, 0), 3.0 * random_number(k, 1), 3.0 * random_number(k, 2)}};
    grains.add(unit_sphere(at, k % 3 == 0), static_cast<std::int64_t>(k));
  }
  const auto box = level_periodic_box(3.0, 3.0);
  const auto found = cells_of(grains, between_levels(0.0, 3.0), box);
  ASSERT_EQ(found.size(), 40U);
  EXPECT_LT(sum_of(found), 27.0 - 1.0);
  std::vector<std::uint32_t> order;
  for (std::uint32_t k = 60; k-- > 0;) order.push_back(k);
  grains.reorder(order);
  const auto again = cells_of(grains, between_levels(0.0, 3.0), box);
  ASSERT_EQ(again.size(), found.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(again[k].volume, found[k].volume);
  std::vector<bool> in_heap(60, false);
  in_heap[1] = true;
  const OrderedGrains<3> ordered(grains, box);
  const auto one = sphere_cells(ordered, in_heap, between_levels(0.0, 3.0), box);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_GT(one[0].volume, 1.5 * found[0].volume);  // found[0] is of grain 1, with all its neighbours
}

}  // namespace
}  // namespace repose
