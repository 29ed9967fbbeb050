// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/visible_part.hpp"
#include "repose/analysis/voronoi.hpp"
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

// Cells at finite walls. Areas are exact to the tolerance of voro++, 1e-11 diameters squared; 1e-10 leaves a margin.

constexpr double area_tolerance = 1e-10;
const double cut_off_area = 32.0 * 2.25 * std::tan(std::numbers::pi / 32.0);

Grain<2> moving_disc(double x, double y, double radius = 0.5) {
  Grain<2> grain;
  grain.position = {{x, y}};
  grain.radius = radius;
  grain.mass = 1.0;
  grain.inverse_mass = 1.0;
  return grain;
}

FlatWall wall_piece(const Vec<2>& from, const Vec<2>& to) {
  const Vec<2> along = to - from;
  const double length = magnitude(along);
  return {from + along * 0.5, Vec<2>{{-along[1], along[0]}} * (1.0 / length), 0.5 * length};
}

std::vector<VoronoiCell> cells_at_walls(const std::vector<Vec<2>>& centres, const std::vector<FlatWall>& walls,
                                        const Box<2>& box = {}) {
  Grains<2> grains;
  for (const auto& centre : centres)
    grains.add(moving_disc(centre[0], centre[1]), static_cast<std::int64_t>(grains.size()));
  return voronoi({grains, box}, std::vector<bool>(grains.size(), true), walls, box);
}

TEST(VoronoiWalls, APieceThatStandsElsewhereDoesNotCut) {
  for (const auto& wall : {wall_piece({{-0.3, 4.0}}, {{-0.3, 9.0}}), wall_piece({{2.0, -0.2}}, {{5.0, -0.2}}),
                           wall_piece({{0.0, -9.0}}, {{0.0, -1.6}})}) {
    const auto cells = cells_at_walls({{{0.0, 0.0}}}, {wall});
    EXPECT_NEAR(cells[0].area, cut_off_area, area_tolerance);
    EXPECT_FALSE(cells[0].closed);
  }
}

TEST(VoronoiWalls, ALongPieceCutsAsAnInfiniteWall) {
  const auto infinite = cells_at_walls({{{0.1, 0.0}}}, {{{{0.0, -0.5}}, {{0.0, 1.0}}}});
  for (const bool reversed : {false, true}) {
    const Vec<2> left{{-8.0, -0.5}};
    const Vec<2> right{{8.0, -0.5}};
    const auto finite = cells_at_walls({{{0.1, 0.0}}}, {reversed ? wall_piece(right, left) : wall_piece(left, right)});
    EXPECT_NEAR(finite[0].area, infinite[0].area, area_tolerance);
  }
}

// The piece is seen under a right angle: it hides a quarter of the cut-off polygon but for the triangle before it.
TEST(VoronoiWalls, AShortPieceHidesWhatLiesBehindIt) {
  const auto cells = cells_at_walls({{{3.0, 1.0}}}, {wall_piece({{2.5, 0.5}}, {{3.5, 0.5}})});
  EXPECT_NEAR(cells[0].area, 0.75 * cut_off_area + 0.25, area_tolerance);
  EXPECT_FALSE(cells[0].closed);
}

// The middle between the two centres lies below the wall, but the wall parts them.
TEST(VoronoiWalls, NeighboursBehindAWallDoNotBoundACell) {
  const auto wall = wall_piece({{-9.0, 0.0}}, {{9.0, 0.0}});
  const auto both = cells_at_walls({{{0.0, 0.5}}, {{0.0, -1.2}}}, {wall});
  EXPECT_NEAR(both[0].area, cells_at_walls({{{0.0, 0.5}}}, {wall})[0].area, area_tolerance);
  EXPECT_NEAR(both[1].area, cells_at_walls({{{0.0, -1.2}}}, {wall})[0].area, area_tolerance);
}

// A square lattice that fills a container made of pieces, with a partition inside: every cell is a closed unit square.
TEST(VoronoiWalls, PiecesThatMeetCloseCells) {
  std::vector<Vec<2>> centres;
  for (int k = 0; k < 48; ++k) centres.push_back({{k % 8 + 0.5, k / 8 + 0.5}});
  std::vector<FlatWall> walls;
  for (int k = 0; k < 8; ++k) {
    walls.push_back(wall_piece({{1.0 * k, 0.0}}, {{k + 1.0, 0.0}}));
    walls.push_back(wall_piece({{1.0 * k, 6.0}}, {{k + 1.0, 6.0}}));
  }
  walls.push_back(wall_piece({{0.0, 0.0}}, {{0.0, 6.0}}));
  walls.push_back(wall_piece({{8.0, 6.0}}, {{8.0, 0.0}}));
  walls.push_back(wall_piece({{3.0, 0.0}}, {{3.0, 6.0}}));
  const auto cells = cells_at_walls(centres, walls);
  ASSERT_EQ(cells.size(), 48U);
  for (const auto& cell : cells) {
    EXPECT_TRUE(cell.closed) << cell.id;
    EXPECT_NEAR(cell.area, 1.0, area_tolerance) << cell.id;
  }
}

// The end of a piece lies inside the cell: a part of the boundary is the line of sight past it.
TEST(VoronoiWalls, ACellThatExtendsPastTheEndOfAPieceIsOpen) {
  std::vector<Vec<2>> centres;
  for (int k = 0; k < 49; ++k) centres.push_back({{k % 7 - 3.0, k / 7 - 3.0}});
  const auto cells = cells_at_walls(centres, {wall_piece({{-0.2, -0.4}}, {{0.2, -0.4}})});
  // Hidden from (0, 0): the trapezium between the piece and the middle line to the neighbour below.
  EXPECT_NEAR(cells[24].area, 1.0 - 0.5 * (0.4 + 0.5) * 0.1, area_tolerance);
  EXPECT_FALSE(cells[24].closed);
  EXPECT_TRUE(cells[22].closed);
  EXPECT_NEAR(cells[22].area, 1.0, area_tolerance);
}

TEST(VoronoiWalls, PiecesActInThePeriodicImagesToo) {
  Box<2> box;
  box.periodic = true;
  box.x_min = 0.0;
  box.x_max = 10.0;
  std::vector<Vec<2>> centres;
  for (int k = 0; k < 10; ++k) centres.push_back({{k + 0.5, 0.5}});
  const auto open = cells_at_walls(centres, {}, box);
  const auto cells = cells_at_walls(centres,
                                    {wall_piece({{10.0, -3.0}}, {{10.0, 3.0}}), wall_piece({{0.0, 0.0}}, {{10.0, 0.0}}),
                                     wall_piece({{1.0, 1.0}}, {{11.0, 1.0}})},
                                    box);
  for (const auto& cell : cells) {
    EXPECT_TRUE(cell.closed) << cell.id;
    EXPECT_NEAR(cell.area, 1.0, area_tolerance) << cell.id;
  }
  EXPECT_FALSE(open[0].closed);
}

/// The area that the centre sees, summed over narrow sectors.
double by_sectors(const std::vector<Vec<2>>& centres, const std::vector<FlatWall>& walls, std::size_t own) {
  const auto cross = [](const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; };
  std::vector<std::pair<Vec<2>, Vec<2>>> pieces;
  for (const auto& wall : walls) {
    const Vec<2> along = Vec<2>{{wall.normal[1], -wall.normal[0]}} * wall.half_length;
    const PieceOfWall piece{wall.point - along - centres[own], wall.point + along - centres[own]};
    // Walls beyond the corners of the cut-off are of no concern.
    if (distance_to(piece) < 1.5 / std::cos(std::numbers::pi / 32.0)) pieces.emplace_back(piece.from, piece.to);
  }
  const auto distance_along = [&](const Vec<2>& direction, const auto& ends) {
    const Vec<2> along = ends.second - ends.first;
    const double turn = cross(direction, along);
    const double at = cross(ends.first, direction) / turn;
    const double distance = cross(ends.first, along) / turn;
    return distance > 0.0 && at >= 0.0 && at <= 1.0 ? distance : 1e9;
  };
  std::vector<Vec<2>> all;
  std::vector<Vec<2>> seen;
  for (int k = 0; k < 32; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 32.0;
    seen.push_back(Vec<2>{{std::cos(angle), std::sin(angle)}} * 3.0);
  }
  all = seen;
  for (std::size_t j = 0; j < centres.size(); ++j) {
    if (j == own) continue;
    const Vec<2> offset = centres[j] - centres[own];
    const Vec<2> direction = offset * (1.0 / magnitude(offset));
    const bool hidden = std::any_of(pieces.begin(), pieces.end(), [&](const auto& ends) {
      return distance_along(direction, ends) < magnitude(offset);
    });
    all.push_back(offset);
    if (!hidden) seen.push_back(offset);
  }
  const auto to_outline = [](const Vec<2>& direction, const std::vector<Vec<2>>& neighbours) {
    double nearest = 1e9;
    for (const auto& offset : neighbours) {
      const double towards = dot(direction, offset);
      if (towards > 0.0) nearest = std::min(nearest, 0.5 * squared(offset) / towards);
    }
    return nearest;
  };
  constexpr int sectors = 100000;
  double sum = 0.0;
  for (int k = 0; k < sectors; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / sectors;
    const Vec<2> direction{{std::cos(angle), std::sin(angle)}};
    double nearest = 1e9;
    for (const auto& ends : pieces) nearest = std::min(nearest, distance_along(direction, ends));
    nearest = nearest < 1e9 ? std::min(nearest, to_outline(direction, seen)) : to_outline(direction, all);
    sum += 0.5 * nearest * nearest * 2.0 * std::numbers::pi / sectors;
  }
  return sum;
}

// 1e5 sectors: each jump of the distance at the end of a piece costs up to one sector, 1e-4 of area.
TEST(VoronoiWalls, AgreesWithSectors) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto random = [&](std::uint64_t index, std::uint32_t draw) {
      return uniform(seed, Purpose::grain_size, index, draw);
    };
    std::vector<Vec<2>> centres;
    for (std::uint64_t k = 0; k < 25; ++k) {
      centres.push_back(
          {{static_cast<double>(k % 5) + 0.4 * random(k, 0), static_cast<double>(k / 5) + 0.4 * random(k, 1)}});
    }
    std::vector<FlatWall> walls;
    for (std::uint64_t k = 100; k < 106; ++k) {
      const Vec<2> from{{5.0 * random(k, 0), 5.0 * random(k, 1)}};
      walls.push_back(wall_piece(from, from + Vec<2>{{3.0 * random(k, 2) - 1.5, 3.0 * random(k, 3) - 1.5}}));
    }
    const auto cells = cells_at_walls(centres, walls);
    for (std::size_t k = 0; k < centres.size(); ++k) {
      EXPECT_NEAR(cells[k].area, by_sectors(centres, walls, k), 5e-4) << seed << ' ' << k;
    }
  }
}

// Gaps and jumps: what a view past two pieces that nearly meet counts as.
TEST(VoronoiWalls, ANarrowGapBetweenPiecesLeavesACellClosed) {
  Outline square{{{{1.0, -1.0}}, {{1.0, 1.0}}, {{-1.0, 1.0}}, {{-1.0, -1.0}}}, {1, 1, 1, 0}};
  const auto with_gap = [&](double gap) {
    return visible_part(square, square, {{{{-2.0, -0.5}}, {{-gap, -0.5}}}, {{{0.0, -0.5}}, {{2.0, -0.5}}}});
  };
  EXPECT_TRUE(with_gap(0.0).closed);
  EXPECT_TRUE(with_gap(1e-4).closed);
  EXPECT_FALSE(with_gap(1e-2).closed);
  EXPECT_FALSE(visible_part(square, square, {}).closed);
  square.bounded[3] = 1;
  EXPECT_TRUE(visible_part(square, square, {}).closed);
  EXPECT_EQ(visible_part(square, square, {}).vertices.size(), 4U);
}

}  // namespace
}  // namespace repose
