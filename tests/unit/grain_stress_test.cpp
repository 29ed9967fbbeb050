// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/grain_stress.hpp"

#include "support/fields.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose {
namespace {

/// Force times branch of all contacts: from the second centre, or the wall, to the first.
std::array<double, 4> global_stress(const LatticePile& pile) {
  std::array<double, 4> sum{};
  for (const auto& contact : pile.contacts.list) {
    const Vec<2> force = force_of(contact);
    const Vec<2> branch = contact.normal * (contact.second < 0 ? 0.5 : 1.0);
    for (int k = 0; k < 4; ++k) sum[static_cast<std::size_t>(k)] += force[k / 2] * branch[k % 2];
  }
  return sum;
}

// A column of discs between walls that touch it: each cell is a square of side d, and the stress at depth h of the
// centre below the top of the column is rho g h, rho = m/d^2. Rounding, and the tolerance of voro++ for areas.
TEST(GrainStress, ColumnOfDiscsCarriesRhoGH) {
  constexpr int high = 10;
  LatticePile column;
  for (int row = 0; row < high; ++row) {
    column.grains.add(unit_disc(0.0, 0.5 + row), row);
    Contact<2> below;
    below.first = row;
    below.second = row > 0 ? row - 1 : wall_partner(0);
    below.normal = {{0.0, 1.0}};
    below.first_lever = 0.5;
    below.normal_force = high - row;
    column.contacts.list.push_back(below);
  }
  const OrderedGrains<2> grains(column.grains, {});
  const std::vector<FlatWall> walls{{{{0.0, 0.0}}, {{0.0, 1.0}}},
                                    {{{-0.5, 0.0}}, {{1.0, 0.0}}},
                                    {{{0.5, 0.0}}, {{-1.0, 0.0}}},
                                    {{{0.0, 10.0}}, {{0.0, -1.0}}}};
  const auto cells = voronoi(grains, moving(column.grains), walls, {});
  const auto stresses = grain_stresses(grains, column.contacts, cells, {});
  ASSERT_EQ(stresses.size(), 10U);
  for (int row = 0; row < high; ++row) {
    const auto& grain = stresses[static_cast<std::size_t>(row)];
    EXPECT_TRUE(grain.in_cell);
    EXPECT_NEAR(grain.area, 1.0, 1e-9);
    EXPECT_NEAR(grain.stress[3], high - row - 0.5, 1e-8);
    for (const std::size_t k : {0U, 1U, 2U}) EXPECT_NEAR(grain.stress[k], 0.0, 1e-12);
  }
}

// Area times stress adds up to the stress of all contacts, also where grains are fixed, and whatever the areas are. In
// a lattice pile each disc has its own sum; the lowest row has parts of the wall. Rounding.
TEST(GrainStress, SumOverGrainsIsTheStressOfAllContacts) {
  auto pile = lattice_pile(12);
  for (const bool fixed : {false, true}) {
    if (fixed) {
      for (std::size_t k = 0; k < 12; ++k) pile.grains.line[k].inverse_mass = 0.0;
    }
    const OrderedGrains<2> grains(pile.grains, {});
    const auto cells = voronoi(grains, moving(pile.grains), {}, {});
    const auto stresses = grain_stresses(grains, pile.contacts, cells, {});
    const auto global = global_stress(pile);
    std::array<double, 4> sum{};
    std::size_t in_cells = 0;
    for (const auto& grain : stresses) {
      in_cells += grain.in_cell ? 1 : 0;
      if (!grain.in_cell) {
        EXPECT_NEAR(grain.area, 0.25 * std::numbers::pi, 1e-12);
      }
      for (std::size_t k = 0; k < 4; ++k) sum[k] += grain.area * grain.stress[k];
    }
    EXPECT_GT(in_cells, 20U);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(sum[k], global[k], 1e-10 * global[3]);
  }
}

// A disc in the lattice pile carries s_yy = (n_l + n_r)/2 and s_xx a third of that, per area sqrt(3)/2 of its cell
// (fields_test.cpp); n counts the discs above a contact, whose means over the four contacts are those at the centre.
TEST(GrainStress, DiscsOfTheLatticePile) {
  const auto pile = lattice_pile(20);
  const OrderedGrains<2> grains(pile.grains, {});
  const auto stresses = grain_stresses(grains, pile.contacts, voronoi(grains, moving(pile.grains), {}, {}), {});
  std::size_t compared = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& place = grains->line[k].position;
    if (!stresses[k].in_cell || place[1] < 0.5) continue;
    ++compared;
    const double left = place[0] - place[1] / std::sqrt(3.0) + 0.5;
    const double right = 19.0 - place[0] - place[1] / std::sqrt(3.0) + 0.5;
    EXPECT_NEAR(stresses[k].area, 0.5 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(stresses[k].stress[3], 0.5 * (left + right), 1e-8);
    EXPECT_NEAR(stresses[k].stress[0], (left + right) / 6.0, 1e-8);
    EXPECT_NEAR(stresses[k].stress[1], (right - left) * std::sqrt(3.0) / 6.0, 1e-8);
  }
  EXPECT_GT(compared, 50U);
}

}  // namespace
}  // namespace repose
