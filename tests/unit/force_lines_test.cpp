// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/force_lines.hpp"

#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {
namespace {

constexpr double threshold = 0.2;

ForceLines lines_of(const Grains<2>& grains, const Contacts<2>& contacts) {
  return find_force_lines({grains, Box<2>{}}, contacts, threshold);
}

// A disc of the equilateral pile with a discs on its diagonal up to the left and b on that up to the right (both with
// itself) presses with a/sqrt(3) down to the right and b/sqrt(3) down to the left; those above press on it with (a - 1)
// and (b - 1). So its strongest contact is the one below with the larger of a and b, and the weakest the smallest that
// is not 0: on the right of the axis, where a > b, strong lines run down to the right and weak ones to the left. Discs
// on the ground have no contacts below but the ground's: N = (a + b)/2 = (k + 1)/2. Rounding.
TEST(ForceLines, OfTheEquilateralPileRunAlongItsDiagonals) {
  constexpr int rows = 12;
  const auto pile = lattice_pile(rows);
  const auto lines = lines_of(pile.grains, pile.contacts);
  ASSERT_EQ(lines.grains.size(), pile.grains.size());
  EXPECT_EQ(lines.horizontal, 0U);
  EXPECT_EQ(lines.largest_horizontal, 0.0);
  EXPECT_EQ(lines.contacts, static_cast<std::size_t>(rows * (rows - 1)));
  std::size_t k = 0;
  for (int r = 0; r < rows; ++r) {
    for (int j = 0; j < rows - r; ++j, ++k) {
      const double a = j + 1;
      const double b = rows - r - j;
      const auto& line = lines.grains[k];
      ASSERT_EQ(line.id, pile.grains.id[k]);
      const double below = r > 0 ? std::max(a, b) : 0.5 * std::sqrt(3.0) * (a + b);
      EXPECT_NEAR(line.strongest_force, std::max(below, std::max(a, b) - 1.0) / std::sqrt(3.0), 1e-12);
      double weakest = r > 0 ? std::min(a, b) : below;
      if (a > 1.0) weakest = std::min(weakest, a - 1.0);
      if (b > 1.0) weakest = std::min(weakest, b - 1.0);
      EXPECT_NEAR(line.weakest_force, weakest / std::sqrt(3.0), 1e-12);
      if (r == 0 || a == b) continue;  // on the axis both lines are equally strong
      const auto& strongest = pile.contacts.list[static_cast<std::size_t>(line.strongest)];
      const double down = strongest.first == line.id ? -1.0 : 1.0;
      EXPECT_NEAR(down * strongest.normal[0], a > b ? 0.5 : -0.5, 1e-12);
      EXPECT_NEAR(down * strongest.normal[1], -0.5 * std::sqrt(3.0), 1e-12);
    }
  }
}

// A row of three discs between two fixed ones: the contacts along the row are horizontal, that with a wall at the side
// is not one between grains. Forces below the threshold, and ones that are not numbers, do not count.
TEST(ForceLines, CountHorizontalContactsBetweenGrains) {
  Grains<2> grains;
  for (int k = 0; k < 5; ++k) grains.add(unit_disc(k, 0.0, k == 0 || k == 4), k);
  grains.add(unit_disc(2.0, 1.0), 5);
  Contacts<2> contacts;
  contacts.list = {
      contact_between(grains, 0, 1, 1.0), contact_between(grains, 1, 2, 3.0), contact_between(grains, 2, 3, 0.1),
      contact_between(grains, 3, 4, std::numeric_limits<double>::quiet_NaN()), contact_between(grains, 2, 5, 2.0)};
  Contact<2> wall;
  wall.first = 5;
  wall.second = wall_partner(0);
  wall.normal = {{1.0, 0.0}};
  wall.normal_force = 0.5;
  contacts.list.push_back(wall);
  const auto lines = lines_of(grains, contacts);
  EXPECT_EQ(lines.contacts, 3U);
  EXPECT_EQ(lines.horizontal, 2U);
  EXPECT_EQ(lines.largest_horizontal, 3.0);
  ASSERT_EQ(lines.grains.size(), 3U);  // 1, 2 and 5
  EXPECT_EQ(lines.grains[0].strongest, 1);
  EXPECT_EQ(lines.grains[0].weakest, 0);
  EXPECT_EQ(lines.grains[1].strongest, 1);
  EXPECT_EQ(lines.grains[1].weakest, 4);
  EXPECT_EQ(lines.grains[2].strongest, 4);
  EXPECT_EQ(lines.grains[2].weakest, 5);
  EXPECT_EQ(lines.strongest_horizontal, 2U);
  EXPECT_EQ(lines.weakest_horizontal, 1U);  // the contact with the wall is not one between grains
}

// Forces that differ by rounding are equal: the first in the list is taken.
TEST(ForceLines, EqualForcesTakeTheFirst) {
  Grains<2> grains;
  for (int k = 0; k < 3; ++k) grains.add(unit_disc(k, 0.0, k != 1), k);
  for (const double difference : {-1e-9, 0.0, 1e-9}) {
    Contacts<2> contacts;
    contacts.list = {contact_between(grains, 0, 1, 1.0), contact_between(grains, 1, 2, 1.0 + difference)};
    const auto lines = lines_of(grains, contacts);
    ASSERT_EQ(lines.grains.size(), 1U);
    EXPECT_EQ(lines.grains[0].strongest, 0);
    EXPECT_EQ(lines.grains[0].weakest, 0);
  }
}

}  // namespace
}  // namespace repose
