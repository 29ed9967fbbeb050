// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_lines.hpp"
#include "repose/analysis/fields.hpp"
#include "repose/core/random.hpp"
#include "support/fields.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

FlatWall plane(double x, double y, double nx, double ny) {
  const double length = std::hypot(nx, ny);
  return {{{x, y}}, {{nx / length, ny / length}}};
}

FlatWall piece(const Vec<2>& from, const Vec<2>& to) {
  const Vec<2> along = to - from;
  const double length = magnitude(along);
  return {(from + to) * 0.5, Vec<2>{{-along[1], along[0]}} * (1.0 / length), 0.5 * length};
}

/// A square lattice of discs that touch, from x = 0 and y = 0 on, on a floor at -1/2. Each carries those above it.
LatticePile columns_of_discs(int across, int high) {
  LatticePile pile;
  for (int column = 0; column < across; ++column) {
    for (int row = 0; row < high; ++row) {
      const auto place = pile.grains.size();
      pile.grains.add(unit_disc(column, row), static_cast<std::int64_t>(place));
      Contact<2> below;
      below.first = pile.grains.id[place];
      below.second = row > 0 ? pile.grains.id[place - 1] : wall_partner(0);
      below.normal = {{0.0, 1.0}};
      below.first_lever = 0.5;
      below.normal_force = high - row;
      pile.contacts.list.push_back(below);
    }
  }
  return pile;
}

// A Gaussian that ends at the floor, y = 0: W(y - p)/Phi(p/w) above it. Both averages over cells are exact, so the
// tolerance is rounding.
TEST(FieldsAtWalls, GaussianEndsAtAFloor) {
  Grains<2> grains;
  const double p = 0.4;
  const double width = 1.5;
  grains.add(unit_disc(0.0, p), 0);
  const auto fields = coarse_grained({grains, {}}, {}, {true}, {}, {width, 0.0, {plane(0.0, 0.1, 0.0, 1.0)}});
  const auto normal = [&](double y) { return 0.5 * std::erfc(-(y - p) / (width * std::numbers::sqrt2)); };
  for (std::size_t row = 0; row < fields.y.size(); ++row) {
    double mass = 0.0;
    for (std::size_t k = 0; k < fields.x.size(); ++k) mass += fields.density[row * fields.x.size() + k];
    const double low = std::max(0.1, fields.y[row] - 0.5 * fields.cell);
    const double high = std::max(0.1, fields.y[row] + 0.5 * fields.cell);
    EXPECT_NEAR(mass * fields.cell * fields.cell, (normal(high) - normal(low)) / (1.0 - normal(0.1)), 1e-13);
    EXPECT_NEAR(fields.room[row * fields.x.size() + fields.x.size() / 2], (high - low) / fields.cell,
                std::fabs(fields.y[row] - p) < 7.0 * width ? 1e-12 : 1.0);
  }
}

// What the Gaussian loses behind the wall it has more before it, farther in for grains at the wall: a uniform density
// is rho(x) = integral over p > 0 of W(x - p)/Phi(p/w), which is ln 2 = 0.69 at the wall and 1 beyond 4 widths.
// Averages over rows; the density stands for points 1/20 apart, which changes it by (1/20)^2/24 of its curvature, 1e-4.
TEST(FieldsAtWalls, AUniformDensityFallsToLn2AtAWall) {
  constexpr double spacing = 0.05;
  const Box<2> box{.periodic = true, .x_min = 0.0, .x_max = spacing};
  Grains<2> grains;
  for (int k = 0; k < 500; ++k) grains.add(unit_disc(0.0, (k + 0.5) * spacing), k);
  const auto fields = coarse_grained({grains, box}, {}, all_of(grains), box, {1.0, 0.0, {plane(0.0, 0.0, 0.0, 1.0)}});
  const auto normal = [](double y) { return 0.5 * std::erfc(-y / std::numbers::sqrt2); };
  const auto mass_below = [&](double x) {
    double mass = 0.0;
    for (double p = 0.0005; p < 20.0; p += 0.001) mass += 0.001 * (normal(x - p) - normal(-p)) / normal(p);
    return mass;
  };
  EXPECT_NEAR(mass_below(0.01) / 0.01, std::log(2.0), 4e-3);  // its slope is about 1/2
  for (const double y : {0.25, 0.75, 1.25, 2.25, 4.25}) {
    double density = 0.0;
    double rows = 0.0;
    for (std::size_t row = 0; row < fields.y.size(); ++row) {
      if (std::fabs(fields.y[row] - y) > 0.25) continue;
      density += fields.density[row * fields.x.size()] * squared(spacing);
      rows += 1.0;
    }
    EXPECT_NEAR(density / rows, (mass_below(y + 0.25) - mass_below(y - 0.25)) / 0.5, 1e-3) << y;
  }
  EXPECT_NEAR((mass_below(4.5) - mass_below(4.0)) / 0.5, 1.0, 2e-3);
}

// Nothing lies behind walls, and the integrals stay: mass, and the sum of force times branch. Rounding only.
TEST(FieldsAtWalls, IntegralsAreExactAndNothingLiesBehind) {
  const auto pile = columns_of_discs(6, 8);
  const std::vector<FlatWall> sides{plane(-0.5, 0.0, 1.0, 0.0), plane(5.5, 0.0, -1.0, 0.0), plane(0.0, -0.5, 0.0, 1.0)};
  auto slopes = sides;
  slopes.push_back(plane(-0.6, -0.5, 1.0, 0.2));
  const std::vector<FlatWall> bin{piece({{-0.5, -0.5}}, {{5.5, -0.5}}), piece({{5.5, -0.5}}, {{6.0, 20.0}}),
                                  piece({{-0.5, 20.0}}, {{-0.5, -0.5}})};
  double force = 0.0;
  for (const auto& contact : pile.contacts.list) force += contact.normal_force * (contact.second < 0 ? 0.5 : 1.0);
  for (const auto& walls : {sides, slopes, bin}) {
    const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, moving(pile.grains), {}, {1.5, 0.0, walls});
    const double cell = fields.cell * fields.cell;
    EXPECT_NEAR(sum(fields.density) * cell, 48.0, 1e-10);
    EXPECT_NEAR(sum(fields.stress[3]) * cell, force, 1e-10 * force);
    EXPECT_NEAR(sum(fields.support[1]) * cell, 48.0, 1e-10);
    const double half = 0.5 * fields.cell;
    std::size_t behind = 0;
    for (std::size_t k = 0; k < fields.density.size(); ++k) {
      const double x = fields.x[k % fields.x.size()];
      const double y = fields.y[k / fields.x.size()];
      const bool outside = x < -0.5 - half || x > 6.0 + half || y < -0.5 - half;
      if (!outside || y > 12.0) continue;
      ++behind;
      EXPECT_EQ(fields.density[k], 0.0) << x << ", " << y;
      EXPECT_EQ(fields.stress[3][k], 0.0) << x << ", " << y;
      EXPECT_EQ(fields.room[k], 0.0);
    }
    EXPECT_GT(behind, 300U);
  }
}

// Columns of discs in a bin carry rho g h: a cut at depth h below the top of the highest disc, h away from its centre,
// carries the weight above it, 6 m g h/d. The row of cells averages a linear load exactly, and the Gaussian leaves it;
// the ripple of the lattice is damped by exp(-2 pi^2) = 3e-9. The floor and the top are 8 widths away.
TEST(FieldsAtWalls, PressureOfColumnsInABin) {
  const auto pile = columns_of_discs(6, 30);
  const std::vector<FlatWall> sides{plane(-0.5, 0.0, 1.0, 0.0), plane(5.5, 0.0, -1.0, 0.0), plane(0.0, -0.5, 0.0, 1.0)};
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, moving(pile.grains), {}, {1.0, 0.0, sides});
  std::size_t compared = 0;
  for (std::size_t row = 0; row < fields.y.size(); ++row) {
    const double depth = 29.5 - fields.y[row];
    if (fields.y[row] < 8.0 || depth < 8.5) continue;
    ++compared;
    double load = 0.0;
    for (std::size_t k = 0; k < fields.x.size(); ++k) load += fields.stress[3][row * fields.x.size() + k] * fields.cell;
    EXPECT_NEAR(load, 6.0 * depth, 1e-6);
  }
  EXPECT_GT(compared, 20U);
}

// A grain beside the end of a wall lies in the light: what the wall hides from it has nothing, the rest has.
TEST(FieldsAtWalls, AFiniteWallThrowsAShadow) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.6), 0);
  const auto fields = coarse_grained({grains, {}}, {}, {true}, {}, {1.0, 0.0, {piece({{-1.0, 0.0}}, {{1.0, 0.0}})}});
  for (std::size_t k = 0; k < fields.density.size(); ++k) {
    const double x = fields.x[k % fields.x.size()];
    const double y = fields.y[k / fields.x.size()];
    if (std::hypot(x, y - 0.6) > 5.0) continue;
    const double edge = y < 0.0 ? (0.6 - y) / 0.6 : 0.0;  // half the width of the shadow
    const double off = fields.cell * (1.0 + std::fabs(y));
    if (y < -fields.cell && std::fabs(x) < edge - off) {
      EXPECT_EQ(fields.density[k], 0.0) << x << ", " << y;
    } else if (y > fields.cell || std::fabs(x) > edge + off) {
      EXPECT_GT(fields.density[k], 0.0) << x << ", " << y;
    }
  }
  EXPECT_NEAR(sum(fields.density) * fields.cell * fields.cell, 1.0, 1e-12);
}

// A row of base grains is one wall where no moving grain passes, and none where one does.
TEST(FieldsAtWalls, ARowOfBaseGrainsIsAWall) {
  const auto row = [](double spacing, int count) {
    Grains<2> grains;
    for (int k = 0; k < count; ++k) grains.add(unit_disc(spacing * k, 0.0, true), k, true);
    grains.add(unit_disc(spacing * 0.5 * count, 0.9), count);
    return grains;
  };
  const auto walls = base_lines({row(1.1, 20), {}}, {});
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_NEAR(walls[0].half_length, 0.5 * 19 * 1.1, 1e-12);
  EXPECT_NEAR(walls[0].point[0], 0.5 * 19 * 1.1, 1e-12);
  EXPECT_TRUE(base_lines({row(2.0, 20), {}}, {}).empty());
  Box<2> box{.periodic = true, .x_min = 0.0, .x_max = 22.0};
  double length = 0.0;
  for (const auto& wall : base_lines({row(1.1, 20), box}, box)) length += 2.0 * wall.half_length;
  EXPECT_NEAR(length, 22.0, 1e-12);

  const auto grains = row(1.1, 20);
  const auto fields = coarse_grained({grains, {}}, {}, moving(grains), {}, {1.5, 0.0, walls});
  double below = 0.0;
  for (std::size_t k = 0; k < fields.density.size(); ++k) {
    if (fields.y[k / fields.x.size()] < -fields.cell) below += fields.density[k] * fields.cell * fields.cell;
  }
  EXPECT_LT(below, 1e-9);  // past the ends of the row, 7 widths away
  EXPECT_NEAR(sum(fields.density) * fields.cell * fields.cell, 1.0, 1e-12);
}

// A grain behind a plane keeps its mass there: walls are not felt.
TEST(FieldsAtWalls, AGrainBehindAPlaneKeepsItsMass) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, -20.0), 0);
  const auto fields = coarse_grained({grains, {}}, {}, {true}, {}, {1.0, 0.0, {plane(0.0, 0.0, 0.0, 1.0)}});
  EXPECT_NEAR(sum(fields.density) * fields.cell * fields.cell, 1.0, 1e-12);
}

}  // namespace
}  // namespace repose
