// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/hybrid_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace repose {
namespace {

using testing::hybrid_settings;
using testing::HybridWorld;
using testing::level_ground;

HybridSettings at_rest(double stiffness) {
  auto settings = hybrid_settings(stiffness);
  settings.walls = {level_ground()};
  settings.spring.damping = 200.0;
  settings.relaxed_start = true;
  return settings;
}

double weight_on_walls(const Contacts<2>& contacts) {
  double sum = 0.0;
  for (const auto& contact : contacts.list) sum += contact.second < 0 ? contact.normal_force : 0.0;
  return sum;
}

bool is_horizontal(const Contact<2>& contact) { return contact.second >= 0 && std::fabs(contact.normal[1]) < 0.1; }

// The equilateral pile of the paper, 45 layers: (42) gives 23 weights under each base disc, (44) a horizontal force on
// the ground of (2 i - 46)/(2 sqrt 3). Soft discs of 1e-5 sink by a few 1e-4, which turns the lines of force by as
// much.
TEST(HybridStatics, TheEquilateralPileCarriesItsWeightAsTheLatticeDoes) {
  auto settings = at_rest(1e5);
  settings.static_friction = 0.6;
  HybridWorld world({}, settings);
  world.add_pile(45);
  world.start();
  ASSERT_EQ(world.grains.size(), 1035U);
  ASSERT_FALSE(world.advance(0).trouble);
  const auto relaxed = world.grains;
  for (const long steps : {0L, 50L}) {
    ASSERT_FALSE(world.advance(steps).trouble);
    const auto contacts = world.method.contacts(world.grains);
    EXPECT_NEAR(weight_on_walls(contacts), 1035.0, 1035e-6);
    EXPECT_EQ(std::count_if(contacts.list.begin(), contacts.list.end(), is_horizontal), 0);
    int base = 0;
    for (const auto& contact : contacts.list) {
      if (contact.second >= 0) continue;
      ++base;
      const double on_ground = (2.0 * static_cast<double>(contact.first + 1) - 46.0) / (2.0 * std::sqrt(3.0));
      EXPECT_NEAR(contact.normal_force, 23.0, 0.005 * 23.0);
      // The tangent of the ground is (-1, 0), and the force in the contact acts on the disc.
      EXPECT_NEAR(contact.tangential_force, on_ground, 0.005 * 12.7017);
    }
    EXPECT_EQ(base, 45);
  }
  // The relaxed places are at rest under the equations of motion too: fifty steps move nothing.
  for (std::size_t k = 0; k < world.grains.size(); ++k) {
    EXPECT_NEAR(world.grains.line[k].position[1], relaxed.line[k].position[1], 1e-9);
  }
}

// A pile of 30 degrees, its base pinned: the weight is carried to rounding, the forces are symmetric, and the pinned
// discs report the horizontal force that holds them.
TEST(HybridStatics, APinnedPileIsSymmetricAndCarriesItsWeight) {
  auto settings = at_rest(1e5);
  settings.pinned_base = true;
  HybridWorld world({}, settings);
  world.add_pile(45, 30.0);
  world.start();
  ASSERT_EQ(world.grains.size(), 360U);
  ASSERT_FALSE(world.advance(0).trouble);
  const auto contacts = world.method.contacts(world.grains);
  EXPECT_NEAR(weight_on_walls(contacts), 360.0, 360e-6);
  std::vector<double> normal;
  std::vector<double> across;
  for (const auto& contact : contacts.list) {
    if (contact.second >= 0) continue;
    normal.push_back(contact.normal_force);
    across.push_back(contact.tangential_force);
  }
  ASSERT_EQ(normal.size(), 45U);
  double outwards = 0.0;
  for (std::size_t k = 0; k < 22; ++k) {
    EXPECT_NEAR(normal[k], normal[44 - k], 1e-5);
    EXPECT_NEAR(across[k], -across[44 - k], 1e-5);
    outwards = std::max(outwards, std::fabs(across[k]));
  }
  EXPECT_GT(outwards, 0.5);
}

// A ground too smooth for the pile lets go: the wells break, and no equilibrium is reported.
TEST(HybridStatics, APileThatSpreadsHasNoEquilibrium) {
  auto settings = at_rest(1e4);
  settings.static_friction = 0.2;
  HybridWorld world({}, settings);
  world.add_pile(10);
  world.start();
  EXPECT_TRUE(world.advance(0).trouble);
  EXPECT_FALSE(world.method.trouble(world.grains).empty());
}

}  // namespace
}  // namespace repose
