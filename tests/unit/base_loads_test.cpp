// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/base_loads.hpp"

#include "repose/scene/read.hpp"
#include "support/sphere_packs.hpp"

#include <gtest/gtest.h>

#include <string>

namespace repose {
namespace {

/// A pyramid of 30 spheres of weight 1 on a wall of a scene with these tables, where planes come before other walls.
Record<3> pyramid_on(const std::string& tables, std::int64_t wall = 0) {
  Record<3> record;
  record.scene = scene_from_text("dimension = 3\nstop = { time = 1 }\nbox = { half_width = 50 }\n" + tables, "scene");
  record.walls = recorded_walls<3>(record.scene, {}, 0.0);
  const packs::SquarePyramid pyramid(4);
  record.grains = OrderedGrains<3>(pyramid.grains, record.box);
  record.contacts = pyramid.contacts;
  for (auto& contact : record.contacts.list) {
    if (contact.second < 0) contact.second = wall_partner(wall);
  }
  return record;
}

double load_of(const BaseLoads& base) {
  double load = 0.0;
  for (const auto& one : base.loads) load -= one.force[2];
  return load;
}

const std::string grain = "[[grain]]\nposition = [0.0, 0.0, 9.0]\n";
const std::string plane = "[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n";
const std::string ceiling = "[[plane]]\npoint = [0.0, 0.0, 30.0]\nnormal = [0.0, 0.0, -1.0]\n";
const std::string side = "[[plane]]\npoint = [9.0, 0.0, 0.0]\nnormal = [-1.0, 0.0, 0.0]\n";

std::string disc(double height, const std::string& more = "") {
  return "[[wall]]\nshape = \"disc\"\ncentre = [0.0, 0.0, " + std::to_string(height) +
         "]\nnormal = [0.0, 0.0, -1.0]\nradius = 9.0\n" + more;
}

/// Half of the contacts with wall 0 are with this one instead.
void move_half(Record<3>& record, std::int64_t wall) {
  std::size_t k = 0;
  for (auto& contact : record.contacts.list) {
    if (contact.second == wall_partner(0) && k++ % 2 == 1) contact.second = wall_partner(wall);
  }
}

TEST(BaseLoads, APlaneOfTheBaseIsTheFloor) {
  const auto base = base_loads(pyramid_on("base = { kind = 'plane' }\n" + grain + disc(-1.0)));
  EXPECT_EQ(base.loads.size(), 16U);
  EXPECT_NEAR(load_of(base), 30.0, 1e-10);
  EXPECT_FALSE(base.area_of_load);
}

// Level walls in a scene without a base; a side, a ceiling and a tilted wall are no floor, whatever presses on them.
TEST(BaseLoads, ALevelWallIsTheFloor) {
  EXPECT_NEAR(load_of(base_loads(pyramid_on(grain + plane + side + ceiling))), 30.0, 1e-10);
  EXPECT_NEAR(load_of(base_loads(pyramid_on(grain + disc(0.0) + side + ceiling, 2))), 30.0, 1e-10);
  for (const auto& none : {side, ceiling, std::string("[[plane]]\npoint = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.1, 1.0]\n"),
                           std::string("[[wall]]\nshape = \"cylinder\"\nfrom = [0.0, 0.0, 0.0]\nto = [0.0, 0.0, 9.0]\n"
                                       "radius = 5.0\n")}) {
    EXPECT_TRUE(base_loads(pyramid_on(grain + none)).loads.empty()) << none;
  }
}

// Walls at one height are one floor; of floors at two heights it is the one that carries more. An open wall is none.
TEST(BaseLoads, TheFloorIsWhatCarriesMost) {
  auto level = pyramid_on(grain + plane + disc(0.0));
  move_half(level, 1);
  EXPECT_NEAR(load_of(base_loads(level)), 30.0, 1e-10);
  auto stairs = pyramid_on(grain + disc(0.0) + disc(-2.0));
  move_half(stairs, 1);
  const double upper = [&] {
    double load = 0.0;
    for (const auto& contact : stairs.contacts.list) {
      if (contact.second == wall_partner(0)) load += contact.normal_force;
    }
    return load;
  }();
  EXPECT_GT(upper, 0.0);
  EXPECT_LT(upper, 30.0);
  EXPECT_NEAR(load_of(base_loads(stairs)), std::max(upper, 30.0 - upper), 1e-10);
  for (auto& standing : stairs.walls) standing.open = true;
  EXPECT_TRUE(base_loads(stairs).loads.empty());
}

// A ring is flat where the ends of its line lie at one height.
TEST(BaseLoads, ARingIsLevel) {
  const auto base =
      base_loads(pyramid_on(
          grain + "[[wall]]\nshape = \"ring\"\ncentre = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\nouter_radius = 9.0\n"
                  "inner_radius = 1.0\n"));
  EXPECT_NEAR(load_of(base), 30.0, 1e-10);
}

// The record has the forces on base grains in grain weights, and the base the area of each.
TEST(BaseLoads, ForcesOnBaseGrains) {
  auto record = pyramid_on("gravity = 2.0\nbase = { kind = 'bed', radius = 3.0, spacing = 1.2 }\n" + grain + plane);
  record.base.id = {0, 1};
  record.base.x = {0.5, 1.0};
  record.base.y = {0.0, -1.0};
  record.base.normal = {3.0, 0.0};
  record.base.shear = {0.25, 0.0};
  record.base.shear_y = {-0.5, 0.0};
  const auto base = base_loads(record);
  ASSERT_EQ(base.loads.size(), 2U);
  EXPECT_EQ(base.loads[0].place, (Vec<2>{{0.5, 0.0}}));
  EXPECT_EQ(base.loads[0].force, (Vec<3>{{0.5, -1.0, -6.0}}));
  EXPECT_EQ(base.loads[1].force, Vec<3>{});
  EXPECT_NEAR(*base.area_of_load, 0.5 * std::sqrt(3.0) * 1.44, 1e-12);
}

}  // namespace
}  // namespace repose
