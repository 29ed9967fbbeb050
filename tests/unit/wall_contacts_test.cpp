// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/boundaries/wall_contacts.hpp"

#include "support/soft_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace repose {
namespace {

using testing::settings_2d;
using testing::SoftWorld;

Wall<2> straight_wall(const Vec<2>& from, const Vec<2>& to) {
  const Vec<2> along = to - from;
  const double length = magnitude(along);
  return {.point = from + along * 0.5,
          .normal = Vec<2>{{-along[1], along[0]}} * (1.0 / length),
          .half_length = 0.5 * length};
}

/// The walls that act on a disc of radius 0.5, by their numbers.
std::vector<std::uint32_t> acting_walls(const std::vector<Wall<2>>& walls, const Vec<2>& centre) {
  WallContacts<2> contacts;
  std::vector<WallNow<2>> now;
  for (const auto& wall : walls) now.push_back(wall_now(wall, {}, 0.0));
  for (std::uint32_t w = 0; w < walls.size(); ++w) {
    const Vec<2> from_point = centre - walls[w].point;
    const auto place = above(walls[w], walls[w].normal, from_point);
    if (place.height < 0.5) contacts.add(w, w, from_point, place);
  }
  contacts.join(walls, now, 0.5);
  std::vector<std::uint32_t> found;
  for (const auto& touch : contacts.all()) {
    if (contacts.acts(touch)) found.push_back(touch.wall);
    EXPECT_TRUE(contacts.acts(contacts.acting_for(touch)));
  }
  return found;
}

using WallNumbers = std::vector<std::uint32_t>;

TEST(WallContacts, OneOfTwoPiecesThatContinueEachOther) {
  const std::vector<Wall<2>> walls{straight_wall({{-2.0, 0.0}}, {{0.0, 0.0}}),
                                   straight_wall({{2.0, 0.0}}, {{0.0, 0.0}})};
  EXPECT_EQ(acting_walls(walls, {{-0.1, 0.49}}), (WallNumbers{0}));
  EXPECT_EQ(acting_walls(walls, {{0.1, 0.49}}), (WallNumbers{1}));
  EXPECT_EQ(acting_walls(walls, {{0.1, -0.49}}), (WallNumbers{1}));
  EXPECT_EQ(acting_walls(walls, {{0.0, 0.49}}), (WallNumbers{1}));  // of equal ones the last
}

TEST(WallContacts, OneOfSeveralAtATip) {
  const std::vector<Wall<2>> walls{straight_wall({{0.0, 0.0}}, {{-1.0, -2.0}}),
                                   straight_wall({{0.0, 0.0}}, {{1.0, -2.0}}),
                                   straight_wall({{0.0, -2.0}}, {{0.0, 0.0}})};
  EXPECT_EQ(acting_walls(walls, {{0.05, 0.45}}), (WallNumbers{2}));
  // Beside the face of the second piece its own face is nearer than the tip.
  EXPECT_EQ(acting_walls(walls, Vec<2>{{0.3, -0.6}} + Vec<2>{{2.0, 1.0}} * (0.49 / std::sqrt(5.0))), (WallNumbers{1}));
}

TEST(WallContacts, BothWallsOfACorner) {
  const std::vector<Wall<2>> walls{straight_wall({{-3.0, 3.0}}, {{0.0, 0.0}}),
                                   straight_wall({{0.0, 0.0}}, {{3.0, 3.0}})};
  EXPECT_EQ(acting_walls(walls, {{0.0, 0.7}}), (WallNumbers{0, 1}));
  EXPECT_EQ(acting_walls(walls, {{-0.3, 0.97}}), (WallNumbers{0}));
}

// Normals that differ by 2 degrees are one surface, by 4 degrees two.
TEST(WallContacts, OneFaceOfASlightBend) {
  const auto bent = [](double degrees) {
    const double angle = 0.5 * degrees * std::numbers::pi / 180.0;
    const Vec<2> right = Vec<2>{{std::cos(angle), std::sin(angle)}} * 3.0;
    return std::vector<Wall<2>>{straight_wall({{-right[0], right[1]}}, {{0.0, 0.0}}),
                                straight_wall({{0.0, 0.0}}, right)};
  };
  EXPECT_EQ(acting_walls(bent(2.0), {{0.001, 0.49}}), (WallNumbers{1}));
  EXPECT_EQ(acting_walls(bent(2.0), {{-0.001, 0.49}}), (WallNumbers{0}));
  EXPECT_EQ(acting_walls(bent(4.0), {{0.001, 0.49}}), (WallNumbers{0, 1}));
}

TEST(WallContacts, AnEndOnAPlaneOrAcrossAPieceIsNoEnd) {
  std::vector<Wall<2>> walls{Wall<2>{.point = {}, .normal = {{0.0, 1.0}}}, straight_wall({{0.0, 0.0}}, {{0.1, -2.0}})};
  EXPECT_EQ(acting_walls(walls, {{0.1, 0.49}}), (WallNumbers{0}));
  walls[0] = straight_wall({{-4.0, 0.0}}, {{4.0, 0.0}});
  EXPECT_EQ(acting_walls(walls, {{0.1, 0.49}}), (WallNumbers{0}));
  EXPECT_EQ(acting_walls(walls, {{0.3, -0.3}}), (WallNumbers{0, 1}));
  // An end that sticks out is one.
  walls[1] = straight_wall({{0.0, 0.02}}, {{0.1, -2.0}});
  EXPECT_EQ(acting_walls(walls, {{0.1, 0.49}}), (WallNumbers{0, 1}));
}

TEST(WallContacts, InfiniteWallsAreNeverOneSurface) {
  const Wall<2> floor{.point = {}, .normal = {{0.0, 1.0}}};
  EXPECT_EQ(acting_walls({floor, floor}, {{0.0, 0.49}}), (WallNumbers{0, 1}));
  auto smooth = straight_wall({{-1.0, 0.0}}, {{1.0, 0.0}});
  smooth.smooth = true;
  EXPECT_EQ(acting_walls({floor, smooth}, {{0.0, 0.49}}), (WallNumbers{0, 1}));
}

// Whatever the walls, the nearest point of all of them acts, and every other acting point is another place.
TEST(WallContacts, TheNearestPointActs) {
  std::vector<Wall<2>> ring;
  constexpr int sides = 9;
  const auto corner = [](int k) {
    const double angle = 2.0 * std::numbers::pi * k / sides;
    return Vec<2>{{0.6 * std::cos(angle), 0.6 * std::sin(angle)}};
  };
  for (int k = 0; k < sides; ++k) ring.push_back(straight_wall(corner(k), corner(k + 1)));
  for (int k = 0; k < 400; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.3) / 400.0;
    const Vec<2> centre{{1.05 * std::cos(angle), 1.05 * std::sin(angle)}};
    const auto found = acting_walls(ring, centre);
    ASSERT_EQ(found.size(), 1U) << k;  // outside of a convex ring
    double nearest = 1e9;
    for (const auto& wall : ring)
      nearest = std::min(nearest, above(wall, wall.normal, Vec<2>(centre - wall.point)).height);
    const auto& acting = ring[found[0]];
    EXPECT_NEAR(above(acting, acting.normal, Vec<2>(centre - acting.point)).height, nearest, 1e-12);
  }
}

// A disc held against a seam by friction: its slip displacement passes on, so the force does not break off.
TEST(WallContacts, SlipPassesOnAtASeam) {
  using Law = PairLaw<Hooke, Linear>;
  auto settings = settings_2d(1e-3, 1.0);
  settings.walls = {straight_wall({{-5.0, 0.0}}, {{0.0, 0.0}}), straight_wall({{0.0, 0.0}}, {{5.0, 0.0}})};
  SoftWorld<2, Law> world(Law{Hooke{1e4, 0.5}, Linear{0.1, 5e3, 0.0}}, settings);
  const auto grain = world.add({{-0.5, 0.5 - 1e-4}}, {{1.0, 0.0}});
  double least = 1.0;
  for (int k = 0; k < 1200; ++k) {
    world.advance(1);
    if (k < 300) continue;
    const auto contacts = world.contacts().list;
    ASSERT_EQ(contacts.size(), 1U) << k;
    least = std::min(least, std::fabs(contacts[0].tangential_force));
  }
  EXPECT_GT(world[grain].position[0], 0.3);
  EXPECT_NEAR(least, 0.1, 1e-4);  // it slides on all the way
}

}  // namespace
}  // namespace repose
