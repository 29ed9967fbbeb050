// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contacts.hpp"

#include <gtest/gtest.h>

// Discs and walls that overlap by a known amount.

namespace repose {
namespace {

Grains<2> two_discs(Vec<2> second) {
  Grains<2> grains;
  Grain<2> grain;
  grain.radius = 0.5;
  grain.position = {{9.0, 1.0}};
  grains.add(grain, 7);
  grain.radius = 0.25;
  grain.position = second;
  grains.add(grain, 4);
  return grains;
}

// The relative overlap is over the mean diameter, the sum of the radii.
TEST(ContactGeometry, OfGrains) {
  const auto contact = contact_of_grains(two_discs({{9.0, 1.6}}), 0, 1, Box<2>{});
  EXPECT_EQ(contact.first, 7);
  EXPECT_EQ(contact.second, 4);
  EXPECT_NEAR(contact.overlap, 0.15, 1e-15);
  EXPECT_NEAR(contact.relative_overlap, 0.2, 1e-15);
  EXPECT_NEAR(contact.normal[1], -1.0, 1e-15);
  EXPECT_EQ(contact.first_lever, 0.5);
  EXPECT_EQ(contact.normal_force, 0.0);
}

TEST(ContactGeometry, OfGrainsAcrossAPeriodicBoundary) {
  Box<2> box;
  box.periodic = true;
  box.x_min = -10.0;
  box.x_max = 10.0;
  const auto contact = contact_of_grains(two_discs({{-10.4, 1.0}}), 0, 1, box);
  EXPECT_NEAR(contact.overlap, 0.15, 1e-14);
  EXPECT_NEAR(contact.normal[0], -1.0, 1e-15);
}

// A smooth wall stands for a row of grain centres: a grain touches it at a whole diameter.
TEST(ContactGeometry, WithAWall) {
  const auto grains = two_discs({{0.0, 5.0}});
  std::vector<Wall<2>> walls(2);
  for (auto& wall : walls) wall.normal = {{0.0, 1.0}};
  walls[1].smooth = true;
  const WallNow<2> now{.point = {{0.0, 0.6}}, .normal = {{0.0, 1.0}}};
  const auto rough = contact_with_wall(grains, 0, walls, 0, now, Box<2>{});
  EXPECT_EQ(rough.first, 7);
  EXPECT_EQ(rough.second, wall_partner(0));
  EXPECT_NEAR(rough.overlap, 0.1, 1e-15);
  EXPECT_NEAR(rough.relative_overlap, 0.1, 1e-15);
  EXPECT_EQ(rough.normal[1], 1.0);
  const auto smooth = contact_with_wall(grains, 0, walls, 1, now, Box<2>{});
  EXPECT_EQ(smooth.second, wall_partner(1));
  EXPECT_NEAR(smooth.overlap, 0.6, 1e-15);
}

}  // namespace
}  // namespace repose
