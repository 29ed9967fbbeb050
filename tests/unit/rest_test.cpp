// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/rest.hpp"

#include "repose/scene/read.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace repose {
namespace {

Grain<2> disc(double x, double speed, double spin = 0.0) {
  Grain<2> grain;
  grain.position = {{x, 0.5}};
  grain.velocity = {{speed, 0.0}};
  grain.rim_velocity = spin;
  grain.radius = 0.5;
  grain.mass = 2.0;
  grain.inverse_mass = 0.5;
  return grain;
}

Contact<2> floor_contact(std::int64_t id, double force) {
  Contact<2> contact;
  contact.first = id;
  contact.second = wall_partner(0);
  contact.normal = {{0.0, 1.0}};
  contact.normal_force = force;
  return contact;
}

const Vec<2> down{{0.0, -1.0}};

// Weight 2, gravity 1: one grain of three moves, one is pressed by a load, one by half of its weight.
TEST(Rest, UnrestIsTheLargestOfAllGrains) {
  Grains<2> grains;
  grains.add(disc(0.0, 0.0), 0);
  grains.add(disc(2.0, 0.3, 0.4), 1);
  grains.add(disc(4.0, 0.0), 2);
  Contacts<2> contacts;
  contacts.list = {floor_contact(0, 2.0), floor_contact(1, 2.0), floor_contact(2, 3.0)};
  const Load<2> load{2, Vec<2>{{0.0, -1.0}}};
  const auto with_load = largest_unrest(grains, contacts, {load}, down, 1.0);
  // v^2/2 + (w r)^2/4 for a disc.
  EXPECT_DOUBLE_EQ(with_load.kinetic_energy, 0.5 * 0.09 + 0.25 * 0.16);
  EXPECT_DOUBLE_EQ(with_load.net_force, 0.0);
  EXPECT_DOUBLE_EQ(largest_unrest(grains, contacts, {}, down, 1.0).net_force, 0.5);
  contacts.list.pop_back();
  EXPECT_DOUBLE_EQ(largest_unrest(grains, contacts, {}, down, 1.0).net_force, 1.0);
}

TEST(Rest, MustLastForTheWindow) {
  const auto scene = scene_from_text(
      "stop = { at_rest = 1e-3 }\noutput = { window = 2.0 }\n[[grain]]\nposition = [0, 1]\n", "scene.toml");
  Rest rest(scene, {0.01, true});
  EXPECT_DOUBLE_EQ(rest.due_after(0.0), 0.5);
  const Unrest quiet{1e-4, 1e-4};
  const Unrest rolling{2e-3, 1e-4};
  EXPECT_FALSE(rest.lasts(quiet, 1.0));
  EXPECT_TRUE(rest.has_just_begun(1.0));
  EXPECT_FALSE(rest.lasts(rolling, 1.5));
  EXPECT_FALSE(rest.lasts(quiet, 2.0));
  EXPECT_FALSE(rest.lasts(quiet, 3.5));
  EXPECT_TRUE(rest.lasts(quiet, 4.0));
}

// A bed behind a gate is not at rest for good before the gate has opened, nor one under a piston that has yet to start.
TEST(Rest, WaitsForWalls) {
  const std::string head = "stop = { at_rest = 1e-3 }\noutput = { window = 2.0 }\n[[grain]]\nposition = [0, 1]\n";
  for (const char* wall : {"[[wall]]\nfrom = [5, 0]\nto = [5, 4]\nopens_at = 40\n",
                           "[[plane]]\npoint = [0, 9]\nnormal = [0, -1]\nmotion = 'velocity'\nvelocity = [0, -0.1]\n"
                           "start = 40\n"}) {
    Rest rest(scene_from_text(head + wall, "scene.toml"), {0.01, true});
    const Unrest quiet{1e-4, 1e-4};
    EXPECT_FALSE(rest.lasts(quiet, 37.0)) << wall;
    EXPECT_FALSE(rest.lasts(quiet, 40.0)) << wall;
    EXPECT_FALSE(rest.lasts(quiet, 40.5)) << wall;
    EXPECT_TRUE(rest.lasts(quiet, 42.5)) << wall;
  }
}

TEST(Rest, ANumberThatIsNoneIsNoRest) {
  Grains<2> grains;
  grains.add(disc(0.0, std::numeric_limits<double>::quiet_NaN()), 0);
  grains.add(disc(2.0, 0.0), 1);
  EXPECT_EQ(largest_unrest<2>(grains, {}, {}, down, 1.0).kinetic_energy, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace repose
