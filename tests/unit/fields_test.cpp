// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"

#include "repose/core/random.hpp"
#include "support/fields.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// Discs of many sizes at random positions.
Grains<2> scattered(int count, double width, double height) {
  Grains<2> grains;
  for (int k = 0; k < count; ++k) {
    const auto draw = [&](std::uint32_t n) {
      return uniform(7, Purpose::grain_size, static_cast<std::uint64_t>(k), n);
    };
    auto grain = unit_disc((draw(0) - 0.5) * width, draw(1) * height);
    grain.radius = 0.2 + 0.4 * draw(2);
    grain.mass = 4.0 * grain.radius * grain.radius;
    grains.add(grain, k);
  }
  return grains;
}

// The Gaussian is averaged over cells exactly, so the only error is rounding of some 1e6 additions.
TEST(Fields, IntegralOfDensityIsTheMass) {
  const auto grains = scattered(300, 40.0, 20.0);
  double mass = 0.0;
  double area = 0.0;
  for (const auto& grain : grains.line) {
    mass += grain.mass;
    area += std::numbers::pi * grain.radius * grain.radius;
  }
  Box<2> periodic;
  periodic.periodic = true;
  periodic.x_min = -20.0;
  periodic.x_max = 20.0;
  for (const auto& box : {Box<2>{}, periodic}) {
    for (const double width : {0.3, 1.5, 4.0}) {
      const auto fields = coarse_grained({grains, box}, {}, all_of(grains), box, {width});
      const double cell = fields.cell * fields.cell;
      EXPECT_NEAR(sum(fields.density) * cell / mass, 1.0, 1e-12);
      EXPECT_NEAR(sum(fields.solid_fraction) * cell / area, 1.0, 1e-12);
    }
  }
}

TEST(Fields, OnlyGrainsOfTheHeapCount) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.0), 0);
  grains.add(unit_disc(0.0, 50.0), 1);
  const auto fields = coarse_grained({grains, {}}, {}, {true, false}, {}, {1.0});
  EXPECT_NEAR(sum(fields.density) * fields.cell * fields.cell, 1.0, 1e-12);
  EXPECT_LT(fields.y.back(), 12.0);
}

TEST(Fields, EmptyWithoutGrains) {
  const Grains<2> none;
  EXPECT_TRUE(coarse_grained({none, {}}, {}, {}, {}, {1.0}).density.empty());
}

// A cell is no wider than a periodic box, so no grid of four million cells can extend from 0 to 1e9.
TEST(Fields, EmptyIfAGrainIsFarAwayInAPeriodicBox) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.0), 0);
  grains.add(unit_disc(0.0, 1e9), 1);
  Box<2> box;
  box.periodic = true;
  box.x_min = -8.0;
  box.x_max = 8.0;
  EXPECT_TRUE(coarse_grained({grains, box}, {}, all_of(grains), box, {1.0}).density.empty());
  grains.line[1].position[1] = 1e6;
  const auto far = coarse_grained({grains, box}, {}, all_of(grains), box, {1.0});
  EXPECT_NEAR(sum(far.density) * far.cell * far.cell, 2.0, 1e-12);
}

// The Gaussian of a single disc, from its definition. The average of a function f over a cell differs from its value at
// the centre by cell^2 laplace(f) / 24 and terms of order cell^4, which are at most 1.2e-5 here.
TEST(Fields, DensityOfOneDiscIsTheGaussian) {
  Grains<2> grains;
  grains.add(unit_disc(0.3, -0.2), 0);
  const double width = 2.0;
  const auto fields = coarse_grained({grains, {}}, {}, all_of(grains), {}, {width});
  for (std::size_t row = 0; row < fields.y.size(); ++row) {
    for (std::size_t column = 0; column < fields.x.size(); ++column) {
      const double d2 = std::pow(fields.x[column] - 0.3, 2) + std::pow(fields.y[row] + 0.2, 2);
      const double expected = std::exp(-d2 / (2.0 * width * width)) / (2.0 * std::numbers::pi * width * width);
      const double curvature = expected * (d2 / std::pow(width, 4) - 2.0 / (width * width));
      EXPECT_NEAR(fields.density[row * fields.x.size() + column],
                  expected + fields.cell * fields.cell * curvature / 24.0, 2e-5);
    }
  }
}

// The pile of the tests below obeys Liffman et al. (1992), eqs 42 and 44, and every disc is in balance.
TEST(Fields, LatticePileIsInBalance) {
  const auto pile = lattice_pile(45);
  ASSERT_EQ(pile.grains.size(), 1035U);
  std::vector<Vec<2>> net(pile.grains.size(), Vec<2>{{0.0, -1.0}});
  double most_shear = 0.0;
  for (const auto& contact : pile.contacts.list) {
    net[static_cast<std::size_t>(contact.first)] += force_of(contact);
    if (contact.second >= 0) {
      net[static_cast<std::size_t>(contact.second)] -= force_of(contact);
    } else {
      EXPECT_NEAR(contact.normal_force, 23.0, 1e-12);
      most_shear = std::max(most_shear, std::fabs(contact.tangential_force));
    }
  }
  EXPECT_NEAR(most_shear, 44.0 / (2.0 * std::sqrt(3.0)), 1e-12);
  for (const auto& force : net) EXPECT_LT(magnitude(force), 1e-12);
}

// Along each diagonal the number of discs above a contact grows linearly downwards: with x from the centre of the left
// corner disc, n_l = x - y/sqrt(3) + 1/2 in the middle of a contact, n_r = 44 - x - y/sqrt(3) + 1/2. Sums of f b over a
// lattice cell of area sqrt(3)/2 give
//   s_yy = (n_l + n_r)/2, s_xx = (n_l + n_r)/6, s_xy = s_yx = (n_r - n_l) sqrt(3)/6.
// A Gaussian does not change linear fields. For w = 1 two errors remain: the ripple of the lattice, damped by
// exp(-(4 pi/sqrt(3))^2 w^2/2) = 4e-12, and the surfaces, 7 widths away: 1e-12. Tolerance: 1e-9.
TEST(Fields, StressOfTheLatticePile) {
  const auto pile = lattice_pile(45);
  const double width = 1.0;
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {width});
  const double away = 7.0 * width + 1.0;
  std::size_t compared = 0;
  for (std::size_t row = 0; row < fields.y.size(); ++row) {
    for (std::size_t column = 0; column < fields.x.size(); ++column) {
      const double x = fields.x[column];
      const double y = fields.y[row];
      const double to_left = (std::sqrt(3.0) * x - y) / 2.0;
      const double to_right = (std::sqrt(3.0) * (44.0 - x) - y) / 2.0;
      if (y < away || to_left < away || to_right < away) continue;
      ++compared;
      const double left = x - y / std::sqrt(3.0) + 0.5;
      const double right = 44.0 - x - y / std::sqrt(3.0) + 0.5;
      const auto cell = row * fields.x.size() + column;
      EXPECT_NEAR(fields.stress[0][cell], (left + right) / 6.0, 1e-9);
      EXPECT_NEAR(fields.stress[1][cell], (right - left) * std::sqrt(3.0) / 6.0, 1e-9);
      EXPECT_NEAR(fields.stress[2][cell], (right - left) * std::sqrt(3.0) / 6.0, 1e-9);
      EXPECT_NEAR(fields.stress[3][cell], (left + right) / 2.0, 1e-9);
    }
  }
  EXPECT_GT(compared, 20U);
}

// The force of the ground on the pile per length of base, from the field of supports. The base discs lie a diameter
// apart, so N = 23 everywhere except near the ends, and H = (n_l - n_r)/(2 sqrt 3) m g on the ground, opposite on the
// pile (Liffman et al. 1992, eqs 42, 44). The ripple of the row is damped by exp(-2 pi^2) = 3e-9 for w = 1.
TEST(Fields, BaseProfileOfTheLatticePile) {
  const auto pile = lattice_pile(45);
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {1.0});
  const auto columns = fields.x.size();
  std::size_t compared = 0;
  for (std::size_t column = 0; column < columns; ++column) {
    const double x = fields.x[column];
    if (x < 7.0 || x > 37.0) continue;
    ++compared;
    double normal = 0.0;
    double shear = 0.0;
    for (std::size_t cell = column; cell < fields.density.size(); cell += columns) {
      shear += fields.support[0][cell] * fields.cell;
      normal += fields.support[1][cell] * fields.cell;
    }
    EXPECT_NEAR(normal, 23.0, 1e-5);
    EXPECT_NEAR(shear, -(2.0 * x - 44.0) / (2.0 * std::sqrt(3.0)), 1e-5);
  }
  EXPECT_GT(compared, 50U);
}

TEST(Fields, TotalsOfStressAndSupport) {
  const auto pile = lattice_pile(12);
  double fb[2][2] = {};
  double weight = 0.0;
  for (const auto& contact : pile.contacts.list) {
    const double branch = contact.second >= 0 ? 1.0 : 0.5;
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) fb[a][b] += force_of(contact)[a] * contact.normal[b] * branch;
    }
    if (contact.second < 0) weight += contact.normal_force;
  }
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {1.0});
  const double cell = fields.cell * fields.cell;
  EXPECT_NEAR(weight, 78.0, 1e-12);
  EXPECT_NEAR(sum(fields.support[1]) * cell / weight, 1.0, 1e-12);
  EXPECT_NEAR(sum(fields.support[0]) * cell, 0.0, 1e-10);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(sum(fields.stress[k]) * cell, fb[k / 2][k % 2], 1e-10);
}

// A horizontal cut carries the weight above it minus the force of the supports above it: the balance of forces,
// integrated over x. The fields are averages over rows. The mean over a row of the load above, R, is the mean of its
// values at the two edges minus cell^2/12 R'' (here from the loads of the neighbouring rows), up to terms of order
// cell^4, below 0.1 % of the weight.
TEST(Fields, EveryCutCarriesTheWeightAboveIt) {
  const auto pile = lattice_pile(20);
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {1.5});
  const auto columns = fields.x.size();
  const auto rows = fields.y.size();
  const double weight = 210.0;
  std::vector<double> load(rows, 0.0);
  std::vector<double> carried(rows, 0.0);
  for (std::size_t cell = 0; cell < rows * columns; ++cell) {
    load[cell / columns] += (fields.density[cell] - fields.support[1][cell]) * fields.cell * fields.cell;
    carried[cell / columns] += fields.stress[3][cell] * fields.cell;
  }
  double above = 0.0;
  double most = 0.0;
  for (std::size_t row = rows - 1; row-- > 1;) {
    const double expected = above + 0.5 * load[row] + (load[row + 1] - load[row - 1]) / 24.0;
    EXPECT_NEAR(carried[row], expected, 1e-3 * weight) << fields.y[row];
    most = std::max(most, carried[row]);
    above += load[row];
  }
  EXPECT_NEAR(above, 0.0, 1e-9);
  EXPECT_GT(most, 0.6 * weight);  // the base lies within a width of the cut with the largest load
}

// Across the side of a periodic box the branch follows the nearest image.
TEST(Fields, PeriodicBranch) {
  Box<2> box;
  box.periodic = true;
  box.x_min = -10.0;
  box.x_max = 10.0;
  Grains<2> grains;
  grains.add(unit_disc(-9.75, 0.0), 0);
  grains.add(unit_disc(9.25, 0.0), 1);
  Contact<2> contact;
  contact.first = 0;
  contact.second = 1;
  contact.normal = {{1.0, 0.0}};
  contact.first_lever = 0.5;
  contact.normal_force = 2.0;
  const auto fields = coarse_grained({grains, box}, Contacts<2>{{contact}}, all_of(grains), box, {1.0});
  EXPECT_NEAR(sum(fields.stress[0]) * fields.cell * fields.cell, 2.0, 1e-12);
  EXPECT_EQ(sum(fields.support[0]), 0.0);
}

}  // namespace
}  // namespace repose
