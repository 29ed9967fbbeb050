// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/near_walls.hpp"

#include "repose/core/random.hpp"
#include "repose/core/team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace repose::contact_dynamics {
namespace {

double number(std::uint64_t index, double from, double to) {
  return from + (to - from) * uniform(7, Purpose::release_position, index);
}

Wall<2> random_wall(std::uint64_t k) {
  const double angle = number(100 * k, 0.0, 6.28);
  Wall<2> wall;
  wall.point = {{number(100 * k + 1, -4.0, 4.0), number(100 * k + 2, -4.0, 4.0)}};
  wall.normal = {{std::cos(angle), std::sin(angle)}};
  wall.smooth = k % 3 == 1;
  if (k % 2 == 0) wall.half_length = number(100 * k + 3, 0.5, 3.0);
  wall.motion.kind = WallMotion<2>::Kind::velocity;
  wall.motion.direction = {{number(100 * k + 4, -0.7, 0.7), 0.7}};
  wall.motion.direction *= 1.0 / magnitude(wall.motion.direction);
  return wall;
}

// Grains move back and forth by less than their allowances, walls by half the skin: contacts are in the list all the
// time.
TEST(NearWalls, ListWhatAGrainMayMeet) {
  constexpr double cutoff = 1.025, skin = 0.3;
  Grains<2> grains;
  for (std::uint64_t k = 0; k < 200; ++k) {
    Grain<2> grain;
    grain.radius = number(7000 + k, 0.3, 0.5);
    grain.inverse_mass = 1.0;
    grain.position = {{number(8000 + k, -6.0, 6.0), number(9000 + k, -6.0, 6.0)}};
    grains.add(grain, static_cast<std::int64_t>(k));
  }
  const Box<2> box;
  Team team(1);
  PairList<2> pairs(PairReach{cutoff, skin, 0.0, 0.0, false});
  pairs.build(grains, box, team);
  std::vector<Wall<2>> walls;
  for (std::uint64_t k = 0; k < 9; ++k) walls.push_back(random_wall(k));
  std::vector<WallState> states(walls.size());
  const auto now = [&] {
    std::vector<WallNow<2>> all;
    for (std::size_t w = 0; w < walls.size(); ++w) all.push_back(wall_now(walls[w], states[w], 0.0));
    return all;
  };
  const auto start = grains.line;
  const auto displace = [&](std::uint64_t round) {
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const double angle = number(20000 + 1000 * round + k, 0.0, 6.28);
      grains.line[k].position = start[k].position;
      grains.line[k].position += Vec<2>{{std::cos(angle), std::sin(angle)}} * (0.999 * pairs.allowance(k));
    }
  };
  displace(0);
  NearWalls<2> near_walls;
  EXPECT_FALSE(near_walls.hold(walls, states, 0.1, skin));
  near_walls.build(grains, walls, states, now(), box, pairs, cutoff, 0.5 * skin);
  std::size_t contacts = 0;
  std::size_t listed = 0;
  for (std::size_t k = 0; k < grains.size(); ++k) listed += near_walls.of(k).size();
  EXPECT_LT(listed, grains.size() * walls.size() / 2);
  for (std::uint64_t round = 1; round < 20; ++round) {
    displace(round);
    for (std::size_t w = 0; w < walls.size(); ++w) {
      states[w].displacement = number(40000 + 100 * round + w, -0.5, 0.5) * skin;
    }
    EXPECT_TRUE(near_walls.hold(walls, states, 0.1, skin));
    const auto moved = now();
    for (std::size_t k = 0; k < grains.size(); ++k) {
      const auto near_grain = near_walls.of(k);
      for (std::uint32_t w = 0; w < walls.size(); ++w) {
        const auto& grain = grains.line[k];
        const auto place = above(walls[w], moved[w].normal, from_wall(walls[w], moved[w], grain.position, box));
        if (-wall_overlap(walls[w], place, grain.radius) >= (cutoff - 1.0) * 2.0 * grain.radius) continue;
        ++contacts;
        EXPECT_EQ(std::count(near_grain.begin(), near_grain.end(), w), 1) << "grain " << k << ", wall " << w;
      }
    }
  }
  EXPECT_GT(contacts, 1000u);
  states[0].displacement = 0.6 * skin;
  EXPECT_FALSE(near_walls.hold(walls, states, 0.1, skin));
  states[0].displacement = 0.4 * skin;
  states[0].speed = 2.0 * skin;
  EXPECT_FALSE(near_walls.hold(walls, states, 0.1, skin));
}

}  // namespace
}  // namespace repose::contact_dynamics
