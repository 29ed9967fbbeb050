// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/chains.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace repose {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

void add_disc(Grains<2>& grains, std::int64_t id, double x, double y, bool fixed = false) {
  Grain<2> grain;
  grain.position = {{x, y}};
  grain.radius = 0.5;
  grain.mass = 1.0;
  grain.inverse_mass = fixed ? 0.0 : 1.0;
  grains.add(grain, id, fixed);
}

Contact<2> contact(std::int64_t first, std::int64_t second, Vec<2> normal, double force) {
  Contact<2> c;
  c.first = first;
  c.second = second;
  c.normal = normal;
  c.normal_force = force;
  return c;
}

/// Twelve grains; 0 and 1 are the base. Strong contacts (2.5 to 4) are: a column 2, 3, 4 on the base grain 0; a
/// slanting row 5, 6 beside it on the same base grain; 7 and 8 on a wall. Weak contacts (2 or 0.5) connect these; three
/// contacts are below the threshold of 0.2.
struct Network {
  Grains<2> grains;
  Contacts<2> contacts;

  Network() {
    // Memory order is not the order of the ids.
    add_disc(grains, 11, 3.0, 2.0);
    add_disc(grains, 0, 0.0, 0.0, true);
    add_disc(grains, 1, 2.0, 0.0, true);
    add_disc(grains, 4, 0.0, 3.0);
    add_disc(grains, 3, 0.0, 2.0);
    add_disc(grains, 2, 0.0, 1.0);
    add_disc(grains, 5, 0.8, 0.6);
    add_disc(grains, 6, 1.6, 1.2);
    add_disc(grains, 7, 4.0, 0.5);
    add_disc(grains, 8, 5.0, 0.5);
    add_disc(grains, 9, 1.0, 3.0);
    add_disc(grains, 10, 2.0, 2.0);
    contacts.list = {
        contact(0, 2, {{0.0, -1.0}}, 4.0),               // row 0
        contact(0, 5, {{-0.8, -0.6}}, 3.0),              // row 1
        contact(2, 3, {{0.0, -1.0}}, 4.0),               // row 2
        contact(3, 4, {{0.0, -1.0}}, 4.0),               // row 3
        contact(4, 9, {{-1.0, 0.0}}, 2.0),               // row 4, weak
        contact(4, 11, {{-1.0, 0.0}}, 0.1),              // row 5
        contact(5, 6, {{-0.8, -0.6}}, 3.0),              // row 6
        contact(6, 10, {{-0.6, -0.8}}, 0.5),             // row 7, weak
        contact(7, wall_partner(0), {{0.0, 1.0}}, 2.5),  // row 8
        contact(7, 8, {{-1.0, 0.0}}, 0.5),               // row 9, weak
        contact(8, wall_partner(0), {{0.0, 1.0}}, 2.5),  // row 10
        contact(9, 10, {{-1.0, 0.0}}, 0.1),              // row 11
        contact(9, 11, {{-1.0, 0.0}}, 0.1),              // row 12
        contact(10, 11, {{-1.0, 0.0}}, 0.5)              // row 13, weak
    };
  }
};

Chains read(const Network& network, double threshold) {
  return find_chains(network.grains, network.contacts, threshold, Box<2>{});
}

// The eleven contacts above 0.2 have the sum 26.5 and the mean 2.41. So the seven named contacts are strong, and the
// contact of 2 is not (with the mean of all fourteen, 1.91, it would be). The base grain belongs to the column and to
// the row but does not link them, and the wall does not link 7 and 8. Tolerances: rounding of a few sums.
TEST(Chains, HandMade) {
  const auto chains = read(Network(), 0.2);
  EXPECT_EQ(chains.chain_of_contact, (std::vector<std::int64_t>{0, 1, 0, 0, -1, -1, 1, -1, 2, -1, 3, -1, -1, -1}));
  ASSERT_EQ(chains.list.size(), 4U);
  const auto& column = chains.list[0];
  EXPECT_EQ(column.contacts, 3U);
  EXPECT_EQ(column.grains, 4U);
  EXPECT_NEAR(column.direction_deg, 90.0, 1e-9);
  EXPECT_EQ(column.width, 0.0);
  EXPECT_NEAR(column.height, 3.0, 1e-12);
  const auto& row = chains.list[1];
  EXPECT_EQ(row.contacts, 2U);
  EXPECT_EQ(row.grains, 3U);
  EXPECT_NEAR(row.direction_deg, std::atan2(0.6, 0.8) * degrees, 1e-9);
  EXPECT_NEAR(row.width, 1.6, 1e-12);
  EXPECT_NEAR(row.height, 1.2, 1e-12);
  for (const auto k : {2U, 3U}) {
    EXPECT_EQ(chains.list[k].contacts, 1U);
    EXPECT_EQ(chains.list[k].grains, 1U);  // the wall is no grain
    EXPECT_NEAR(chains.list[k].direction_deg, 90.0, 1e-9);
    EXPECT_EQ(chains.list[k].width, 0.0);
    EXPECT_EQ(chains.list[k].height, 0.0);
  }
}

// Without a threshold the mean is 26.8 / 14 = 1.91, so the contact of 2 adds grain 9 to the column.
TEST(Chains, TheThresholdSetsTheMean) {
  const auto chains = read(Network(), 0.0);
  ASSERT_EQ(chains.list.size(), 4U);
  EXPECT_EQ(chains.chain_of_contact[4], 0);
  EXPECT_EQ(chains.list[0].contacts, 4U);
  EXPECT_EQ(chains.list[0].grains, 5U);
  EXPECT_NEAR(chains.list[0].width, 1.0, 1e-12);
}

// If the base grain can move, it links column and row to one chain.
TEST(Chains, AMovingGrainLinks) {
  Network network;
  network.grains.line[1].inverse_mass = 1.0;  // id 0
  const auto chains = read(network, 0.2);
  ASSERT_EQ(chains.list.size(), 3U);
  EXPECT_EQ(chains.list[0].contacts, 5U);
  EXPECT_EQ(chains.list[0].grains, 6U);  // it counts once
  EXPECT_NEAR(chains.list[0].width, 1.6, 1e-12);
  EXPECT_NEAR(chains.list[0].height, 3.0, 1e-12);
}

// The axis is in (-90, 90]: descending to the right is negative; vertical is +90, also if rounding puts it just beyond.
TEST(Chains, Direction) {
  for (const double angle : {-89.0, -45.0, 0.0, 30.0, 90.0, -90.0}) {
    Grains<2> grains;
    add_disc(grains, 0, 0.0, 0.0);
    add_disc(grains, 1, std::cos(angle / degrees), std::sin(angle / degrees));
    add_disc(grains, 2, 9.0, 0.0);
    Contacts<2> contacts;
    for (const double sign : {1.0, -1.0}) {
      const Vec<2> normal{{sign * std::cos(angle / degrees), sign * std::sin(angle / degrees)}};
      contacts.list = {contact(0, 1, normal, 2.0), contact(1, 2, {{1.0, 0.0}}, 1.0)};
      const auto chains = find_chains(grains, contacts, 0.0, Box<2>{});
      ASSERT_EQ(chains.list.size(), 1U);
      EXPECT_NEAR(chains.list[0].direction_deg, angle == -90.0 ? 90.0 : angle, 1e-9);
    }
  }
  Grains<2> grains;
  add_disc(grains, 0, 0.0, 0.0);
  Contacts<2> contacts;
  contacts.list = {contact(0, wall_partner(0), {{-1e-17, 1.0}}, 2.0), contact(0, wall_partner(1), {{1, 0}}, 1.0)};
  EXPECT_EQ(find_chains(grains, contacts, 0.0, Box<2>{}).list.at(0).direction_deg, 90.0);
}

// Three grains at 9.5, 0.5 and 1.3 in a box from 0 to 10: along the contacts the chain is 1.8 wide; without the nearest
// images it would be 9.
TEST(Chains, AcrossTheSideOfAPeriodicBox) {
  Grains<2> grains;
  add_disc(grains, 0, 0.5, 1.0);
  add_disc(grains, 1, 1.3, 1.6);
  add_disc(grains, 2, 9.5, 1.0);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{-0.8, -0.6}}, 3.0), contact(0, 2, {{1.0, 0.0}}, 3.0),
                   contact(1, wall_partner(0), {{0.0, 1.0}}, 1.0)};
  Box<2> box;
  box.x_min = 0.0;
  box.x_max = 10.0;
  for (const bool periodic : {true, false}) {
    box.periodic = periodic;
    const auto chains = find_chains(grains, contacts, 0.0, box);
    ASSERT_EQ(chains.list.size(), 1U);
    EXPECT_EQ(chains.list[0].grains, 3U);
    EXPECT_NEAR(chains.list[0].width, periodic ? 1.8 : 9.0, 1e-12);
    EXPECT_NEAR(chains.list[0].height, 0.6, 1e-12);
  }
}

// Chains of equal size are ordered by their first contact, not by their last.
TEST(Chains, EqualOnesByTheirFirstContact) {
  Grains<2> grains;
  for (int k = 0; k < 8; ++k) add_disc(grains, k, k, 0.0);
  Contacts<2> contacts;
  const Vec<2> normal{{-1.0, 0.0}};
  contacts.list = {contact(0, 6, normal, 2.0), contact(1, 2, normal, 2.0), contact(2, 3, normal, 2.0),
                   contact(4, 5, normal, 1.0), contact(6, 7, normal, 2.0)};
  const auto chains = find_chains(grains, contacts, 0.0, Box<2>{});
  EXPECT_EQ(chains.chain_of_contact, (std::vector<std::int64_t>{0, 1, 1, -1, 0}));
}

TEST(Chains, NoneWithoutStrongContacts) {
  const auto none = find_chains(Grains<2>{}, Contacts<2>{}, 0.0, Box<2>{});
  EXPECT_TRUE(none.list.empty());
  EXPECT_TRUE(none.chain_of_contact.empty());
  // Equal forces: none is above the mean.
  Grains<2> grains;
  for (int k = 0; k < 3; ++k) add_disc(grains, k, k, 0.0);
  Contacts<2> contacts;
  contacts.list = {contact(0, 1, {{-1, 0}}, 1.0), contact(1, 2, {{-1, 0}}, 1.0)};
  const auto equal = find_chains(grains, contacts, 0.0, Box<2>{});
  EXPECT_TRUE(equal.list.empty());
  EXPECT_EQ(equal.chain_of_contact, (std::vector<std::int64_t>{-1, -1}));
  // Infinite forces and NaN, from a failed run, do not count: of the forces 3 and 1, one is above the mean.
  contacts.list[0].normal_force = 3.0;
  contacts.list.push_back(contact(0, 2, {{-1, 0}}, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(find_chains(grains, contacts, 0.0, Box<2>{}).chain_of_contact, (std::vector<std::int64_t>{0, -1, -1}));
}

}  // namespace
}  // namespace repose
