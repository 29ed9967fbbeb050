// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/wall_shapes.hpp"

#include "repose/boundaries/make_walls.hpp"
#include "repose/scene/problems.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace repose {
namespace {

/// Keeps "key what" of each problem.
class NotedProblems final : public Problems {
 public:
  std::vector<std::string> all;

  void problem(const std::string& key, const std::string& what) override {
    all.push_back(key + what);
    wrong_.insert(key);
  }
  bool sound(const std::string& key) const override { return !wrong_.contains(key); }
  bool none() const override { return all.empty(); }

 private:
  std::set<std::string> wrong_;
};

std::vector<std::string> problems_of_shape(const ShapeKind& shape) {
  NotedProblems noted;
  shape.check("wall[2].", 1.0, noted);
  return noted.all;
}

Wall<3> only_wall(const ShapeKind& shape) {
  EXPECT_TRUE(problems_of_shape(shape).empty());
  const auto walls = shape.walls();
  EXPECT_EQ(walls.size(), 1u);
  return walls.at(0);
}

/// The names of the keys of a shape.
class KeyNames final : public Parameters {
 public:
  std::vector<std::string> all;

 private:
  void show(const Item& item) override { all.emplace_back(item.name); }
};

TEST(WallShapes, Keys) {
  std::string text;
  for (const auto& kind : shape_kinds().all()) {
    KeyNames names;
    shape_kinds().make(kind->name())->keys(names);
    text += fmt::format("{}: {}\n", kind->name(), fmt::join(names.all, " "));
  }
  EXPECT_EQ(text,
            "disc: centre normal radius\n"
            "ring: centre normal inner_radius outer_radius\n"
            "rectangle: corner side_a side_b\n"
            "cylinder: from to radius\n"
            "cone: from to radius_from radius_to\n"
            "surface: file scale shift\n");
}

TEST(WallShapes, WhereTheyAre) {
  DiscShape disc;
  disc.centre = {1, 2, 3};
  disc.normal = {0, 0, -4};
  disc.radius = 2.0;
  EXPECT_EQ(only_wall(disc).normal, (Vec<3>{{0, 0, -1}}));
  EXPECT_NEAR(area(only_wall(disc)), 4.0 * std::numbers::pi, 1e-14);
  EXPECT_EQ(disc.describe(), "disc of radius 2 at [1, 2, 3]");
  RingShape ring;
  ring.centre = {1, 2, 3};
  ring.normal = {0, 2, 0};
  ring.inner_radius = 1.0;
  ring.outer_radius = 2.0;
  EXPECT_NEAR(area(only_wall(ring)), 3.0 * std::numbers::pi, 1e-14);
  EXPECT_EQ(ring.describe(), "ring of radii 1 and 2 at [1, 2, 3]");
  RectangleShape rectangle;
  rectangle.corner = {0, 0, 1};
  rectangle.side_a = {3, 0, 0};
  rectangle.side_b = {0, 0, 2};
  EXPECT_EQ(only_wall(rectangle).point, (Vec<3>{{1.5, 0, 2}}));
  EXPECT_EQ(only_wall(rectangle).normal, (Vec<3>{{0, -1, 0}}));
  EXPECT_NEAR(area(only_wall(rectangle)), 6.0, 1e-14);
  EXPECT_EQ(rectangle.describe(), "rectangle of 3 by 2 from [0, 0, 1]");
  CylinderShape cylinder;
  cylinder.from = {0, 0, 0};
  cylinder.to = {0, 4, 0};
  cylinder.radius = 1.5;
  EXPECT_EQ(only_wall(cylinder).point, (Vec<3>{{0, 2, 0}}));
  EXPECT_NEAR(area(only_wall(cylinder)), 12.0 * std::numbers::pi, 1e-13);
  EXPECT_EQ(cylinder.describe(), "cylinder of radius 1.5 from [0, 0, 0] to [0, 4, 0]");
  ConicalShape cone;
  cone.from = {0, 0, 0};
  cone.to = {0, 0, 4};
  cone.radius_from = 0.0;
  cone.radius_to = 3.0;
  EXPECT_NEAR(area(only_wall(cone)), 15.0 * std::numbers::pi, 1e-13);
  EXPECT_EQ(cone.describe(), "cone of radius 0 at [0, 0, 0] and 3 at [0, 0, 4]");
}

TEST(WallShapes, WhatIsRefused) {
  using List = std::vector<std::string>;
  DiscShape disc;
  disc.centre = {0, 0, 0};
  disc.normal = {0, 0, 0};
  disc.radius = 1e-7;
  EXPECT_EQ(problems_of_shape(disc), (List{"wall[2].normal = [0, 0, 0]: must have a direction",
                                           "wall[2].radius = 1e-07: must be at least 1e-06 of a diameter"}));
  RingShape ring;
  ring.centre = {0, 0, 0};
  ring.normal = {0, 0, 1};
  ring.inner_radius = 2.0;
  ring.outer_radius = 1.0;
  EXPECT_EQ(problems_of_shape(ring), (List{"wall[2].outer_radius = 1: must be > inner_radius = 2 [L]"}));
  RectangleShape rectangle;
  rectangle.corner = {0, 0, 0};
  rectangle.side_a = {1, 0, 0};
  rectangle.side_b = {1, 1, 0};
  EXPECT_EQ(problems_of_shape(rectangle),
            (List{"wall[2].side_b = [1, 1, 0]: must be perpendicular to side_a = [1, 0, 0]"}));
  rectangle.side_b = {0, 0, 0};
  EXPECT_EQ(problems_of_shape(rectangle),
            (List{"wall[2].side_b = [0, 0, 0]: must be at least 1e-06 of a diameter long"}));
  CylinderShape cylinder;
  cylinder.from = cylinder.to = {1, 1, 1};
  cylinder.radius = 1.0;
  EXPECT_EQ(problems_of_shape(cylinder), (List{"wall[2].to = [1, 1, 1]: is where the wall begins"}));
  ConicalShape cone;
  cone.from = {0, 0, 0};
  cone.to = {0, 0, 1};
  cone.radius_from = cone.radius_to = 0.0;
  EXPECT_EQ(problems_of_shape(cone), (List{"wall[2].radius_to = 0: one radius must be > 0"}));
}

TEST(WallShapes, Surface) {
  const auto folder = std::filesystem::temp_directory_path();
  const auto path = folder / "repose_wall_shapes.stl";
  const auto write = [&](double height) {
    std::ofstream(path) << "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 " << height
                        << "\nendloop\nendfacet\nendsolid\n";
  };
  write(0.0);
  SurfaceShape surface;
  surface.file = "repose_wall_shapes.stl";
  surface.scale = 2.0;
  surface.shift = {0, 0, 5};
  surface.find(folder.string());
  EXPECT_EQ(only_wall(surface).normal, (Vec<3>{{0, 0, 1}}));
  EXPECT_NEAR(area(only_wall(surface)), 2.0, 1e-15);
  EXPECT_NEAR(only_wall(surface).point[2], 5.0, 1e-15);
  EXPECT_EQ(surface.describe(), "surface of 1 triangles from repose_wall_shapes.stl");
  // A file that changes is read again.
  write(1.0);
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(2));
  EXPECT_NEAR(area(only_wall(surface)), 2.0 * std::numbers::sqrt2, 1e-14);
  std::filesystem::remove(path);
  EXPECT_EQ(
      problems_of_shape(surface),
      (std::vector<std::string>{"wall[2].file = \"repose_wall_shapes.stl\": " + path.string() + ": no such file"}));
}

}  // namespace
}  // namespace repose
