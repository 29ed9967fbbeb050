// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/ordered_grains.hpp"
#include "repose/record/recorded_wall.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"

#include <gtest/gtest.h>

namespace repose {
namespace {

TEST(OrderedGrains, AreSortedAndInsideTheBox) {
  Box<2> box;
  box.periodic = true;
  box.x_min = -2.0;
  box.x_max = 2.0;
  Grains<2> grains;
  for (const auto& [id, x] : {std::pair{7, 3.0}, {2, -2.5}, {4, 0.5}}) {
    Grain<2> grain;
    grain.position = {{x, 0.1 * id}};
    grain.mass = id;
    grains.add(grain, id, id == 2, static_cast<std::uint16_t>(id));
  }
  const OrderedGrains<2> ordered(grains, box);
  EXPECT_EQ(ordered->id, (std::vector<std::int64_t>{2, 4, 7}));
  EXPECT_EQ(ordered->base, (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(ordered->line[0].position, (Vec<2>{{1.5, 0.1 * 2}}));
  EXPECT_EQ(ordered->line[1].position, (Vec<2>{{0.5, 0.1 * 4}}));
  EXPECT_EQ(ordered->line[2].position, (Vec<2>{{-1.0, 0.1 * 7}}));
  EXPECT_EQ(ordered->line[2].mass, 7.0);
  EXPECT_EQ(ordered.find(4), 1U);
  EXPECT_FALSE(ordered.find(3));
  EXPECT_FALSE(ordered.find(8));
}

const auto scene_with_walls = R"(
[base]
kind = "plane"
[[plane]]
name = "piston"
point = [0.0, 9.0]
normal = [0.0, -1.0]
motion = "velocity"
velocity = [0.0, -0.5]
[[wall]]
name = "gate"
from = [3.0, 0.0]
to = [3.0, 4.0]
opens_at = 2.0
[[grain]]
position = [0.0, 1.0]
[stop]
time = 4
)";

TEST(RecordedWalls, StandWhereTheyAreAtThatTime) {
  const auto scene = scene_from_text(scene_with_walls, "scene.toml");
  std::vector<WallState> states(3);
  states[1].displacement = 0.75;
  const auto before = recorded_walls(scene, states, 1.5);
  ASSERT_EQ(before.size(), 3U);
  EXPECT_EQ(before[1].name, "piston");
  EXPECT_EQ(before[1].start, (Vec<2>{{0.0, 9.0}}));
  EXPECT_EQ(before[1].wall.point, (Vec<2>{{0.0, 8.25}}));
  EXPECT_EQ(before[0].wall.point, before[0].start);
  EXPECT_FALSE(before[2].open);
  EXPECT_TRUE(recorded_walls(scene, states, 2.0)[2].open);
}

TEST(RecordedWalls, MessagesNameThem) {
  const auto scene = scene_from_text(scene_with_walls, "scene.toml");
  EXPECT_EQ(partner_name(scene, 12), "grain 12");
  EXPECT_EQ(partner_name(scene, -1), "wall base");
  EXPECT_EQ(partner_name(scene, -3), "wall gate");
}

}  // namespace
}  // namespace repose
