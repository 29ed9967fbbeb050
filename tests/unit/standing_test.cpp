// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/standing.hpp"

#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

namespace repose {
namespace {

using namespace packs;

/// Eight spheres above each other; the first is fixed.
Grains<3> tower() {
  Grains<3> grains;
  for (int k = 0; k < 8; ++k) grains.add(unit_sphere({{0.0, 0.0, 1.0 * k}}, k == 0), 10 + k);
  return grains;
}

Contact<3> on_wall(const Grains<3>& grains, std::size_t k) {
  Contact<3> contact;
  contact.first = grains.id[k];
  contact.second = wall_partner(0);
  return contact;
}

TEST(Standing, OnlyWhatHangsTogetherWithFixedGrainsOrWalls) {
  const auto grains = tower();
  Contacts<3> contacts;
  for (const auto& [upper, lower] : {std::pair{2, 1}, {1, 0}, {4, 3}, {7, 6}}) {
    contacts.list.push_back(sphere_contact(grains, upper, lower, 1.0));
  }
  contacts.list.push_back(on_wall(grains, 6));
  // 1 and 2 on the fixed one; 3 and 4 collide in the air; 5 touches nothing; 6 and 7 on the wall.
  EXPECT_EQ(standing(grains, contacts), (std::vector<bool>{false, true, true, false, false, false, true, true}));
}

TEST(Standing, NothingWithoutContacts) {
  const auto grains = tower();
  EXPECT_EQ(standing(grains, Contacts<3>{}), std::vector<bool>(8, false));
}

}  // namespace
}  // namespace repose
