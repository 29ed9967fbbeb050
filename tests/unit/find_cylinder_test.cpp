// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/find_pipe.hpp"
#include "repose/results/column.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/read.hpp"
#include "repose/theory/janssen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace repose {
namespace {

const std::string upright_cylinder =
    "[[wall]]\nname = \"pipe\"\nshape = \"cylinder\"\nfrom = [2, 1, 0]\nto = [2, 1, 40]\nradius = 3\n";
const std::string level_plane = "[[plane]]\nname = \"f\"\npoint = [0, 0, 1]\nnormal = [0, 0, 1]\n";

Scene cylinder_scene(const std::string& walls, const std::string& first = "base = { kind = \"none\" }\n") {
  return scene_from_text("dimension = 3\n" + first + "[[grain]]\nposition = [2, 1, 4]\n[stop]\ntime = 9\n" + walls,
                         "scene");
}

std::optional<WallsOfPipe<3>> cylinder_in(const std::string& walls,
                                          const std::string& first = "base = { kind = \"none\" }\n") {
  return find_pipe<3>(cylinder_scene(walls, first));
}

TEST(FindCylinder, AnUprightCylinderAndAFloor) {
  const std::string lid = "[[plane]]\nname = \"lid\"\npoint = [0, 0, 90]\nnormal = [0, 0, -1]\n";
  const auto found = cylinder_in(lid + level_plane + upright_cylinder);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->side, 2U);
  EXPECT_EQ(found->floor, 1U);
  const auto pipe = found->at(recorded_walls<3>(cylinder_scene(lid + level_plane + upright_cylinder), {}, 0.0));
  EXPECT_EQ(pipe.wall, 2);
  EXPECT_EQ(pipe.axis, (Vec<2>{{2.0, 1.0}}));
  EXPECT_NEAR(pipe.radius, 3.0, 1e-12);
  EXPECT_EQ(pipe.floor, 1.0);
  std::string down = upright_cylinder;
  down.replace(down.find("from"), 4, "to").replace(down.rfind("to ="), 2, "from");
  EXPECT_TRUE(cylinder_in(down + level_plane)) << "either end may come first";
  EXPECT_TRUE(cylinder_in(upright_cylinder, "base = { kind = \"plane\" }\n"));
  const auto on_bed = cylinder_in(upright_cylinder, "base = { kind = \"bed\", radius = 6 }\n");
  ASSERT_TRUE(on_bed);
  EXPECT_FALSE(on_bed->floor);
}

TEST(FindCylinder, FloorsOfFiniteExtent) {
  const auto disc = [](const std::string& at, double radius) {
    return "[[wall]]\nname = \"d\"\nshape = \"disc\"\ncentre = " + at +
           "\nnormal = [0, 0, -1]\nradius = " + std::to_string(radius) + "\n";
  };
  EXPECT_TRUE(cylinder_in(upright_cylinder + disc("[2, 1, 5]", 3.0)));
  EXPECT_TRUE(cylinder_in(upright_cylinder + disc("[6, 1, 5]", 1.1)));
  EXPECT_FALSE(cylinder_in(upright_cylinder + disc("[6, 1, 5]", 0.9))) << "beside the cylinder";
  EXPECT_FALSE(cylinder_in(upright_cylinder + disc("[2, 1, 41]", 3.0))) << "above it";
  const auto ring = [](double inner) {
    return "[[wall]]\nname = \"r\"\nshape = \"ring\"\ncentre = [2, 1, 5]\nnormal = [0, 0, 1]\ninner_radius = " +
           std::to_string(inner) + "\nouter_radius = 8\n";
  };
  EXPECT_TRUE(cylinder_in(upright_cylinder + ring(1.0)));
  EXPECT_FALSE(cylinder_in(upright_cylinder + ring(3.5))) << "around it";
  const auto lowest = cylinder_in(upright_cylinder + disc("[2, 1, 5]", 3.0) + level_plane);
  ASSERT_TRUE(lowest);
  EXPECT_EQ(lowest->floor, 0U) << "planes come first";
}

TEST(FindCylinder, NoneInOtherScenes) {
  const auto with = [](const std::string& what, const std::string& by) {
    std::string text = upright_cylinder;
    return text.replace(text.find(what), what.size(), by) + level_plane;
  };
  EXPECT_FALSE(cylinder_in(upright_cylinder)) << "no floor";
  EXPECT_FALSE(cylinder_in(level_plane));
  EXPECT_FALSE(cylinder_in(with("to = [2, 1, 40]", "to = [2.1, 1, 40]"))) << "leans";
  EXPECT_FALSE(cylinder_in(with("to = [2, 1, 40]", "to = [40, 1, 0]"))) << "lies";
  EXPECT_FALSE(cylinder_in(level_plane + "[[wall]]\nname = \"c\"\nshape = \"cone\"\nfrom = [2, 1, 0]\nto = [2, 1, 40]\n"
                                         "radius_from = 3\nradius_to = 3.1\n"))
      << "widens";
  EXPECT_FALSE(cylinder_in(upright_cylinder + with("\"pipe\"", "\"inner\""))) << "two";
  EXPECT_FALSE(cylinder_in(upright_cylinder + level_plane +
                           "[[plane]]\nname = \"s\"\npoint = [-60, 0, 0]\nnormal = [1, 0, 0]\n"));
  EXPECT_FALSE(cylinder_in(upright_cylinder + level_plane +
                           "[[plane]]\nname = \"s\"\npoint = [0, 0, -60]\nnormal = [1, 0, 1]\n"));
  EXPECT_FALSE(cylinder_in(upright_cylinder + level_plane, "box = { x = \"periodic\" }\nbase = { kind = \"none\" }\n"));
  EXPECT_FALSE(cylinder_in(upright_cylinder + level_plane, "box = { y = \"periodic\" }\nbase = { kind = \"none\" }\n"));
  EXPECT_FALSE(
      cylinder_in(upright_cylinder + level_plane, "gravity_direction = [1, 0, -1]\nbase = { kind = \"none\" }\n"));
}

/// A record of one row whose slices have the stresses of Janssen's law in a cylinder of diameter 6.
Record<3> cylinder_record(const std::string& direction, double ratio, double friction) {
  constexpr int slices = 40;
  Record<3> record;
  record.scene = cylinder_scene(level_plane + upright_cylinder + "[output]\nslices = 40\n");
  record.walls = recorded_walls<3>(record.scene, {}, 0.0);
  theory::Janssen law{
      .dimension = 3, .width = 6.0, .stress_ratio = ratio, .friction = friction, .direction = direction};
  const double area = theory::area(law);
  const double perimeter = std::numbers::pi * law.width;
  const double height = 30.0;
  record.series.push_back({.time = 1.0, .grains = 1});
  record.column_series.push_back({.height = height, .centre = 15.0, .solid_fraction = law.solid_fraction});
  double carried = 0.0;
  for (int k = 0; k < slices; ++k) {
    const double low = height * k / slices;
    const double high = height * (k + 1) / slices;
    ColumnSlice slice{.top = high, .mass = law.solid_fraction * area * (high - low)};
    slice.load = area * theory::vertical_stress(law, height - low);
    const double above = area * theory::vertical_stress(law, height - high);
    slice.pressure = ratio * 0.5 * (slice.load + above) / area;
    slice.shear = (above + slice.mass - slice.load) / (perimeter * (high - low));
    carried += slice.shear * perimeter * (high - low);
    record.column_slices.push_back(slice);
  }
  const double floor = record.column_slices.front().load;
  record.wall_series = {{.force = {{0.0, 0.0, -floor}}}, {.force = {{0.0, 0.0, -carried}}}};
  return record;
}

// K, mobilised friction and both fitted lengths of a column that obeys Janssen's law, at rest and pushed up: the length
// is the diameter over four times K times friction. K and friction are from the mean of two levels, which is off by
// (slice/length)^2/12.
TEST(CylinderColumn, FindsTheLawOfJanssen) {
  for (const std::string direction : {"rest", "pushed-up"}) {
    const double sense = direction == "rest" ? 1.0 : -1.0;
    const auto column = measure_column_of(cylinder_record(direction, 0.6, 0.4));
    ASSERT_TRUE(column);
    const double length = 6.0 / (4.0 * 0.6 * 0.4);
    EXPECT_NEAR(column->radius, 3.0, 1e-12);
    EXPECT_TRUE(std::isnan(column->width));
    EXPECT_EQ(column->axis, (Vec<2>{{2.0, 1.0}}));
    EXPECT_EQ(column->floor, 1.0);
    EXPECT_NEAR(column->mass, 0.6 * 9.0 * std::numbers::pi * 30.0, 1e-9);
    ASSERT_TRUE(column->stress_ratio);
    EXPECT_NEAR(column->stress_ratio->mean, 0.6, 1e-9);
    EXPECT_NEAR(column->friction, sense * 0.4, 1e-3);
    EXPECT_NEAR(column->screening_length, sense * length, 1e-2);
    EXPECT_NEAR(column->balance, 0.0, 1e-12);
    EXPECT_NEAR(column->load_ratio / column->janssen_ratio, 1.0, 5e-3);
    EXPECT_NEAR(column->fit.lambda, length, 1e-6) << direction;
    EXPECT_NEAR(column->fit.lambda_1, length, 1e-4) << direction;
    EXPECT_NEAR(column->fit.lambda_2, length, 1e-4) << direction;
    EXPECT_NEAR(column->layers[20].solid_fraction, 0.6, 1e-9);
    EXPECT_NEAR(column->layers[0].depth, 30.0 - 0.375, 1e-12);
    EXPECT_NEAR(column->layers[39].stress, 0.5 * column->layers[39].load / (9.0 * std::numbers::pi), 1e-12);
  }
}

// Grains around a cylinder are no column.
TEST(CylinderColumn, NoneWhereNoGrainHasBeenInside) {
  auto record = cylinder_record("rest", 0.6, 0.4);
  record.column_series.back().height = 0.0;
  EXPECT_FALSE(measure_column_of(record));
}

// A floor that rises, and a cylinder that moves sideways: the place is that of the walls at the end.
TEST(CylinderColumn, FollowsAFloorThatMoves) {
  Record<3> record;
  record.scene =
      cylinder_scene(level_plane + "motion = \"velocity\"\nvelocity = [0, 0, 0.5]\nstart = 1\n" + upright_cylinder +
                     "motion = \"velocity\"\nvelocity = [0.25, 0, 0]\nstart = 0\n[output]\nwindow = 1\nslices = 4\n");
  const auto add = [&](double time, double floor, const std::vector<double>& tops) {
    record.series.push_back({.time = time});
    record.column_series.push_back({.height = tops.back(), .centre = 0.5 * tops.back(), .solid_fraction = 0.6});
    for (const double top : tops) record.column_slices.push_back({.top = top, .mass = 1.0});
    record.wall_series.insert(record.wall_series.end(), {{.displacement = floor}, {.displacement = 0.25 * time}});
  };
  add(1.0, 0.0, {1.0, 2.0, 3.0, 4.0});
  add(2.0, 0.5, {0.9, 1.8, 2.5, 3.5});  // the upper two stand still
  add(3.0, 1.0, {0.9, 1.8, 2.5, 3.5});  // all have risen by more than 0.5
  record.walls = recorded_walls<3>(record.scene, {{.displacement = 1.0}, {.displacement = 0.75}}, 3.0);
  const auto column = measure_column_of(record);
  ASSERT_TRUE(column);
  EXPECT_NEAR(column->floor, 2.0, 1e-12);
  EXPECT_NEAR(column->axis[0], 2.75, 1e-12);
  ASSERT_EQ(column->motion.size(), 2U);
  EXPECT_NEAR(column->motion[0].shortening, 0.5, 1e-12);
  EXPECT_NEAR(column->motion[0].front, 2.0, 1e-12);
  EXPECT_NEAR(column->motion[1].front, 4.0, 1e-12);
  EXPECT_NEAR(column->motion[1].top, 0.5, 1e-12);
  EXPECT_NEAR(column->top_follows, 1.0, 1e-12);
  EXPECT_NEAR(column->shortening, 0.5, 1e-12);
}

}  // namespace
}  // namespace repose
