// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/boundaries/walls_near.hpp"

#include "repose/core/team.hpp"
#include "repose/methods/contact_dynamics/near_walls.hpp"
#include "repose/methods/wall_list.hpp"
#include "support/walls_3d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace repose {
namespace {

using testing::Draws;
constexpr double list_cutoff = 1.025, list_skin = 0.3, box_half_width = 6.0;

template <int D>
Vec<D> place_within(Draws& draws, double largest) {
  Vec<D> place;
  for (int k = 0; k < D; ++k) place[k] = draws.number(-largest, largest);
  return place;
}

/// A wall of random shape, some of them endless, smooth or absent.
template <int D>
Wall<D> some_wall(Draws& draws, int k) {
  Wall<D> wall;
  if constexpr (D == 3) {
    wall = testing::random_wall(draws, k % 9 == 0 ? 4.0 : 0.8, box_half_width);
  } else {
    const Vec<3> along = draws.direction();
    const double length = std::sqrt(along[0] * along[0] + along[1] * along[1]);
    wall = {.point = place_within<2>(draws, box_half_width), .normal = {{along[0] / length, along[1] / length}}};
    wall.half_length = draws.number(0.1, k % 9 == 0 ? 4.0 : 0.8);
  }
  if (k == 7) {
    wall = Wall<D>{.point = wall.point, .normal = wall.normal};
  }
  wall.smooth = k % 5 == 1;
  if (k % 11 == 3) wall.opens_at = 0.0;
  return wall;
}

template <int D>
struct WallWorld {
  Grains<D> grains;
  Box<D> box;
  std::vector<Wall<D>> walls;
  std::vector<WallNow<D>> now;
  PairList<D> pairs{PairReach{list_cutoff, list_skin, 0.5, 1.0, false}};
  Team team{1};
  std::vector<std::uint32_t> order;

  WallWorld(int walls_in_all, bool periodic, std::uint64_t seed) {
    Draws draws(seed);
    for (int k = 0; k < 300; ++k) {
      Grain<D> grain;
      grain.radius = draws.number(0.2, 0.5);
      grain.inverse_mass = k % 17 == 0 ? 0.0 : 1.0;
      grain.position = place_within<D>(draws, box_half_width);
      if (k % 13 == 0) grain.velocity = place_within<D>(draws, 8.0);  // fast: its allowance is longer
      grains.add(grain, k);
    }
    box.periodic = periodic;
    box.x_min = -box_half_width;
    box.x_max = box_half_width;
    if constexpr (D == 3) {
      box.periodic_y = periodic;
      box.y_min = -box_half_width;
      box.y_max = box_half_width;
    }
    for (int k = 0; k < walls_in_all; ++k) {
      walls.push_back(some_wall<D>(draws, k));
      now.push_back(wall_now(walls.back(), {}, 1.0));
    }
    order = pairs.build(grains, box, team);
  }
};

/// Pairs by a check of every wall for every grain.
template <int D>
std::size_t check_wall_list(WallWorld<D>& world) {
  WallList<D> list(world.walls.size());
  list.build(world.grains, world.order, world.walls, world.now, world.box, world.pairs, list_cutoff, list_skin);
  contact_dynamics::NearWalls<D> near_walls;
  near_walls.build(world.grains, world.walls, std::vector<WallState>(world.walls.size()), world.now, world.box,
                   world.pairs, list_cutoff, 0.2);
  std::size_t listed = 0;
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    const auto& grain = world.grains.line[i];
    std::vector<std::uint32_t> soft, rigid;
    for (std::uint32_t w = 0; w < world.walls.size() && !grain.fixed(); ++w) {
      const auto& wall = world.walls[w];
      const auto place = above(wall, world.now[w], from_wall(wall, world.now[w], grain.position, world.box));
      const double within = (wall.smooth ? 2.0 * list_cutoff : 2.0 * list_cutoff - 1.0) * grain.radius;
      const double allowance = world.pairs.allowance(i);
      if (world.now[w].present && place.height < within + 0.5 * list_skin + allowance) soft.push_back(w);
      if (place.height < within + 0.2 + 2.0 * allowance) rigid.push_back(w);
    }
    std::vector<std::uint32_t> found;
    for (const auto& pair : list.row(i)) found.push_back(pair.wall);
    EXPECT_EQ(found, soft) << i;
    const auto near_grain = near_walls.of(i);
    EXPECT_EQ(std::vector<std::uint32_t>(near_grain.begin(), near_grain.end()), rigid) << i;
    listed += soft.size();
  }
  std::size_t of_walls = 0;
  for (const auto& of : list.of_wall) of_walls += of.size();
  EXPECT_EQ(of_walls, listed);
  return listed;
}

template <int D>
void check_wall_lists() {
  for (const bool periodic : {false, true}) {
    for (const int walls : {1, 20, 25, 40, 600}) {
      WallWorld<D> world(walls, periodic, 20 + static_cast<std::uint64_t>(walls));
      const auto listed = check_wall_list(world);
      if (walls < 25) continue;
      EXPECT_GT(listed, 10u * static_cast<unsigned>(walls) / 25u);
      EXPECT_LT(listed, world.grains.size() * world.walls.size() / 5);
      // Walls that have moved since give a new tree.
      for (auto& now : world.now) now.point[1] += 0.7;
      check_wall_list(world);
    }
  }
}

TEST(WallsNear, TheSamePairsAsWithoutATreeIn2d) { check_wall_lists<2>(); }
TEST(WallsNear, TheSamePairsAsWithoutATreeIn3d) { check_wall_lists<3>(); }

// One tree that takes walls again where they stand elsewhere must not answer for the old places.
TEST(WallsNear, FollowsWalls) {
  std::vector<Wall<3>> walls;
  for (int k = 0; k < 100; ++k) walls.push_back(disc_wall({{1.0 * k, 0, 0}}, {{0, 0, 1}}, 0.4));
  auto now = testing::standing(walls);
  WallsNear<3> near;
  const auto found_at = [&](double x) {
    std::vector<std::uint32_t> found;
    near.each(Vec<3>{{x, 0, 0}}, 0.3, Box<3>{}, [&](std::uint32_t w) { found.push_back(w); });
    return found;
  };
  near.take(walls, now);
  EXPECT_EQ(found_at(50.0), (std::vector<std::uint32_t>{50}));
  EXPECT_EQ(found_at(50.5), (std::vector<std::uint32_t>{50, 51}));
  EXPECT_TRUE(found_at(-3.0).empty());
  for (auto& wall : now) wall.point[0] -= 3.0;
  near.take(walls, now);
  EXPECT_EQ(found_at(50.0), (std::vector<std::uint32_t>{53}));
  EXPECT_EQ(found_at(-3.0), (std::vector<std::uint32_t>{0}));
}

// Half extents hold all of a wall and no more: the farthest of many of its points comes close on each side.
TEST(WallsNear, HalfExtent) {
  Draws draws(31);
  for (int k = 0; k < 200; ++k) {
    const auto wall = testing::random_wall(draws, 1.0, 2.0);
    const auto now = wall_now(wall, {}, 0.0);
    const Vec<3> half = half_extent(wall, now);
    Vec<3> farthest{};
    for (int l = 0; l < 3000; ++l) {
      const Vec<3> outside = wall.point + draws.direction() * 50.0;
      const auto found = above(wall, now, Vec<3>(outside - wall.point));
      const Vec<3> nearest = outside - found.normal * found.height - wall.point;
      for (int axis = 0; axis < 3; ++axis) {
        farthest[axis] = std::max(farthest[axis], std::fabs(nearest[axis]));
        EXPECT_LE(std::fabs(nearest[axis]), half[axis] + 1e-9);
      }
      EXPECT_LE(magnitude(nearest), wall.half_length + 1e-9);
    }
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(farthest[axis], 0.9 * half[axis]);
  }
}

}  // namespace
}  // namespace repose
