// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace repose::theory {
namespace {

using Place = std::array<double, 3>;

struct Lattice {
  std::array<Place, 3> edges;  ///< edges of the unit cell; in 2D the third is (0, 0, 1)
  std::vector<Place> grains;   ///< positions in the cell, in units of the edges
};

struct Counted {
  double solid_fraction;
  double coordination;
};

// Each grain touches its nearest neighbours, found in the surrounding cells. The solid fraction is the area or volume
// of the grains in a cell over that of the cell.
Counted count(const Lattice& lattice, int dimension) {
  const auto place = [&](const Place& grain, int i, int j, int k) {
    Place all{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all[axis] = (grain[0] + i) * lattice.edges[0][axis] + (grain[1] + j) * lattice.edges[1][axis] +
                  (grain[2] + k) * lattice.edges[2][axis];
    }
    return all;
  };
  std::vector<double> distances;
  const int deep = dimension == 3 ? 2 : 0;
  for (const auto& grain : lattice.grains) {
    const auto here = place(grain, 0, 0, 0);
    for (const auto& other : lattice.grains) {
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          for (int k = -deep; k <= deep; ++k) {
            const auto there = place(other, i, j, k);
            distances.push_back(std::hypot(here[0] - there[0], here[1] - there[1], here[2] - there[2]));
          }
        }
      }
    }
  }
  std::erase_if(distances, [](double distance) { return distance < 1e-9; });
  const double diameter = *std::ranges::min_element(distances);
  const auto touching = std::ranges::count_if(distances, [&](double d) { return d < diameter * (1.0 + 1e-9); });
  const auto& [a, b, c] = lattice.edges;
  const double cell = std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                               a[2] * (b[0] * c[1] - b[1] * c[0]));
  const double radius = 0.5 * diameter;
  const double grain =
      dimension == 2 ? std::numbers::pi * radius * radius : 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const auto grains = static_cast<double>(lattice.grains.size());
  return {.solid_fraction = grains * grain / cell, .coordination = static_cast<double>(touching) / grains};
}

TEST(Packing, LatticesAsCountedInTheirCells) {
  const double root3 = std::sqrt(3.0);
  const std::array<Place, 3> cube = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::map<std::pair<std::string, int>, Lattice> lattices = {
      {{"hexagonal", 2}, {{{{1, 0, 0}, {0.5, 0.5 * root3, 0}, {0, 0, 1}}}, {{0, 0, 0}}}},
      {{"square", 2}, {cube, {{0, 0, 0}}}},
      {{"face-centred cubic", 3}, {cube, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}}},
      {{"hexagonal close", 3},
       {{{{1, 0, 0}, {0.5, 0.5 * root3, 0}, {0, 0, std::sqrt(8.0 / 3.0)}}}, {{0, 0, 0}, {1.0 / 3.0, 1.0 / 3.0, 0.5}}}},
      {{"body-centred cubic", 3}, {cube, {{0, 0, 0}, {0.5, 0.5, 0.5}}}},
      {{"simple cubic", 3}, {cube, {{0, 0, 0}}}},
      // Hexagonal close packing in a cell with three spheres in each of two layers, of which one is missing: layers are
      // honeycombs.
      {{"tunneled crystal", 3},
       {{{{1.5, 0.5 * root3, 0}, {1.5, -0.5 * root3, 0}, {0, 0, std::sqrt(8.0 / 3.0)}}},
        {{1.0 / 3.0, 1.0 / 3.0, 0}, {2.0 / 3.0, 2.0 / 3.0, 0}, {1.0 / 3.0, 0, 0.5}, {2.0 / 3.0, 1.0 / 3.0, 0.5}}}},
  };
  std::size_t exact = 0;
  for (const auto& fact : packing_facts()) {
    if (fact.error != 0.0) continue;
    const auto counted = count(lattices.at({fact.name, fact.dimension}), fact.dimension);
    EXPECT_NEAR(fact.solid_fraction, counted.solid_fraction, 1e-14) << fact.name;
    EXPECT_EQ(fact.coordination, counted.coordination) << fact.name;
    ++exact;
  }
  EXPECT_EQ(exact, lattices.size());
}

// Kepler, Thue: no packing is denser. Every row has a source, and every number except those of lattices has an error or
// is marked as having none.
TEST(Packing, NothingIsDenserThanTheDensest) {
  for (const auto& fact : packing_facts()) {
    EXPECT_FALSE(fact.source.empty()) << fact.name;
    if (std::isnan(fact.solid_fraction)) continue;
    EXPECT_LE(fact.solid_fraction, fact.dimension == 2 ? 0.9069 : 0.74049) << fact.name;
  }
}

// Counts of balances: discs have x, y (and a torque with friction), spheres x, y, z (and three torques).
TEST(Packing, IsostaticCounts) {
  EXPECT_EQ(isostatic_coordination(2, false), 4.0);
  EXPECT_EQ(isostatic_coordination(2, true), 3.0);
  EXPECT_EQ(isostatic_coordination(3, false), 6.0);
  EXPECT_EQ(isostatic_coordination(3, true), 4.0);
}

// Contact directions with P = (1 + A cos 2 theta)/(2 pi), summed at equal steps, which is exact for harmonics.
TEST(Packing, BoundsOfAnisotropy) {
  const auto table = evaluate(Packing{});
  const auto fabric = [](double harmonic) {
    double xx = 0.0;
    double trace = 0.0;
    constexpr int steps = 360;
    for (int i = 0; i < steps; ++i) {
      const double theta = 2.0 * std::numbers::pi * i / steps;
      const double p = (1.0 + harmonic * std::cos(2.0 * theta)) / steps;
      EXPECT_GE(p, -1e-15);
      xx += p * std::cos(theta) * std::cos(theta);
      trace += p;
    }
    return std::pair{trace, 2.0 * (2.0 * xx - trace)};  // the other eigenvalue is trace - xx
  };
  const auto [trace, anisotropy] = fabric(1.0);
  EXPECT_NEAR(trace, table.number("fabric_trace"), 1e-13);
  EXPECT_NEAR(anisotropy, table.number("anisotropy_bound_one_harmonic"), 1e-13);
  EXPECT_NEAR(fabric(0.4).second, 0.4, 1e-13);
  // If all contacts are along x, the eigenvalues are 1 and 0.
  EXPECT_EQ(2.0 * (1.0 - 0.0), table.number("anisotropy_bound"));
}

TEST(Packing, PicksADimension) {
  const auto all = evaluate(Packing{}).column("name").words.size();
  const auto discs = evaluate(Packing{.dimension = "2"}).column("dimension").values;
  const auto spheres = evaluate(Packing{.dimension = "3"}).column("dimension").values;
  EXPECT_EQ(discs, std::vector<double>(discs.size(), 2.0));
  EXPECT_EQ(discs.size() + spheres.size(), all);
  EXPECT_GT(discs.size(), 4u);
}

}  // namespace
}  // namespace repose::theory
