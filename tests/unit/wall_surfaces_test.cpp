// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

// Walls of three dimensions that meet: they act as one surface.

#include "repose/methods/wall_list.hpp"
#include "support/walls_3d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace repose {
namespace {

using testing::acting_touches;
using testing::cut_square;
using testing::Draws;
constexpr double sphere_radius = 0.5;

std::vector<Wall<3>> walls_of_triangles(const std::vector<std::array<Vec<3>, 3>>& triangles) {
  std::vector<Wall<3>> walls;
  for (const auto& [a, b, c] : triangles) walls.push_back(triangle_wall(a, b, c));
  return walls;
}

double height_over_all(const std::vector<Wall<3>>& walls, const Vec<3>& centre) {
  double least = 1e9;
  for (const auto& wall : walls) {
    least = std::min(least, above(wall, wall_now(wall, {}, 0.0), Vec<3>(centre - wall.point)).height);
  }
  return least;
}

// A plane of 200 triangles of all sizes, many of them slivers: at every place one contact with the normal of the plane,
// also where a long-ranged law or a deep overlap brings dozens of triangles into reach, and on both sides.
TEST(WallSurfaces, APlaneOfTriangles) {
  Draws draws(11);
  const auto walls = walls_of_triangles(cut_square(draws, 6.0, 99));
  ASSERT_EQ(walls.size(), 200u);
  double total = 0.0;
  for (const auto& wall : walls) total += area(wall);
  ASSERT_NEAR(total, 36.0, 1e-12);
  std::size_t most = 0;
  const auto check = [&](const Vec<3>& centre, double reach) {
    std::size_t near = 0;
    for (const auto& wall : walls) {
      near += above(wall, wall_now(wall, {}, 0.0), Vec<3>(centre - wall.point)).height < reach ? 1 : 0;
    }
    most = std::max(most, near);
    const auto acting = acting_touches(walls, centre, sphere_radius, reach);
    ASSERT_EQ(acting.size(), 1u) << centre[0] << " " << centre[1] << " " << centre[2];
    EXPECT_NEAR(acting[0].place.height, std::fabs(centre[2]), 1e-12);
    EXPECT_NEAR(acting[0].place.normal[2], centre[2] > 0.0 ? 1.0 : -1.0, 1e-12);
    EXPECT_NEAR(magnitude(Vec<3>{{acting[0].place.normal[0], acting[0].place.normal[1], 0.0}}), 0.0, 1e-9);
  };
  // Dragged along lines, one of which is the first diagonal, a seam all along.
  for (int k = 0; k <= 3000; ++k) {
    const double x = 0.6 + 4.8 * k / 3000.0;
    check({{x, x, 0.499}}, sphere_radius);
    check({{x, 0.3 + 0.9 * x, 0.49}}, sphere_radius);
    check({{x, 5.7 - 0.9 * x, -0.45}}, sphere_radius);
  }
  for (int k = 0; k < 2000; ++k) {
    check({{draws.number(0.2, 5.8), draws.number(0.2, 5.8), draws.number(0.05, 0.5)}}, 1.5 * sphere_radius);
  }
  // Above corners.
  for (const auto& wall : walls) {
    for (const auto& corner : wall.shape.corners) {
      const Vec<3> at = wall.point + wall.shape.side * corner[0] + cross(wall.normal, wall.shape.side) * corner[1];
      if (at[0] < 0.1 || at[0] > 5.9 || at[1] < 0.1 || at[1] > 5.9) continue;
      check({{at[0], at[1], 0.48}}, sphere_radius);
    }
  }
  EXPECT_GT(most, 30u);
}

// A ridge: the direction of the one contact turns at most by as much as the sphere moves, over its height.
TEST(WallSurfaces, AConvexEdge) {
  const auto walls = walls_of_triangles({{{{{-2, -3, -1.5}}, {{2, -3, -1.5}}, {{0, 0, 0}}}},
                                         {{{{2, -3, -1.5}}, {{2, 3, -1.5}}, {{0, 0, 0}}}},
                                         {{{{2, 3, -1.5}}, {{-2, 3, -1.5}}, {{0, 0, 0}}}},
                                         {{{{-2, 3, -1.5}}, {{-2, -3, -1.5}}, {{0, 0, 0}}}}});
  for (const double y : {0.0, 0.2, -0.7}) {
    Vec<3> last{};
    Vec<3> before{};
    for (int k = 0; k <= 2000; ++k) {
      const double x = -1.0 + 0.001 * k;
      // As deep in the surface as in a smoothed one: by bisection of the height at a distance of 0.49.
      double low = -1.5, high = 1.0;
      for (int n = 0; n < 60; ++n) {
        const double z = 0.5 * (low + high);
        (height_over_all(walls, {{x, y, z}}) < 0.49 || z < -0.5 * (std::fabs(x) + std::fabs(y)) ? low : high) = z;
      }
      const Vec<3> centre{{x, y, high}};
      const auto acting = acting_touches(walls, centre, sphere_radius, sphere_radius);
      ASSERT_EQ(acting.size(), 1u) << x;
      EXPECT_NEAR(acting[0].place.height, 0.49, 1e-9);
      const Vec<3> normal = acting[0].place.normal;
      if (k > 0) {
        EXPECT_LE(magnitude(Vec<3>(normal - last)), 1.001 * magnitude(Vec<3>(centre - before)) / 0.49 + 1e-9) << x;
      }
      last = normal;
      before = centre;
    }
  }
}

// A valley of two triangles at a right angle holds a sphere in it on both sides, and one beside it on one.
TEST(WallSurfaces, AConcaveCorner) {
  const auto walls =
      walls_of_triangles({{{{{-3, 0, 3}}, {{0, -9, 0}}, {{0, 9, 0}}}}, {{{{3, 0, 3}}, {{0, 9, 0}}, {{0, -9, 0}}}}});
  for (const double y : {-1.0, 0.0, 0.3}) {
    const double rest = sphere_radius * std::sqrt(2.0) - 1e-3;
    const auto both = acting_touches(walls, {{0.0, y, rest}}, sphere_radius, sphere_radius);
    ASSERT_EQ(both.size(), 2u);
    for (const auto& touch : both) EXPECT_NEAR(touch.place.normal[2], std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(both[0].place.normal[0] + both[1].place.normal[0], 0.0, 1e-12);
    EXPECT_EQ(acting_touches(walls, {{0.2, y, rest + 0.2}}, sphere_radius, sphere_radius).size(), 1u);
  }
}

// Lid and wall of a can: outside one contact everywhere, over the rim too; in the corner inside two.
TEST(WallSurfaces, ALidOnACylinder) {
  const std::vector<Wall<3>> can{frustum_wall({{0, 0, 0}}, {{0, 0, 2}}, 1.5, 1.5),
                                 disc_wall({{0, 0, 2}}, {{0, 0, 1}}, 1.5), disc_wall({{0, 0, 0}}, {{0, 0, 1}}, 1.5)};
  Draws draws(12);
  int rims = 0;
  for (int k = 0; k < 4000; ++k) {
    const double turn = draws.number(0.0, 2.0 * std::numbers::pi);
    const Vec<3> outwards{{std::cos(turn), std::sin(turn), 0.0}};
    const double angle = draws.number(-0.4, 0.5 * std::numbers::pi + 0.4);
    const Vec<3> rim = outwards * 1.5 + Vec<3>{{0, 0, 2}};
    // A little above the lid, around the rim, or beside the cylinder.
    Vec<3> centre = rim + outwards * (0.49 * std::cos(angle)) + Vec<3>{{0, 0, 0.49 * std::sin(angle)}};
    if (angle < 0.0) centre = rim + outwards * 0.49 + Vec<3>{{0, 0, angle}};
    if (angle > 0.5 * std::numbers::pi)
      centre = rim + Vec<3>{{0, 0, 0.49}} - outwards * (angle - 0.5 * std::numbers::pi);
    const auto acting = acting_touches(can, centre, sphere_radius, sphere_radius);
    ASSERT_EQ(acting.size(), 1u) << angle;
    EXPECT_NEAR(acting[0].place.height, 0.49, 1e-12);
    rims += angle > 0.0 && angle < 0.5 * std::numbers::pi ? 1 : 0;
    const Vec<3> inside = outwards * (1.5 - 0.49) + Vec<3>{{0, 0, 2.0 - 0.48}};
    const auto corner = acting_touches(can, inside, sphere_radius, sphere_radius);
    ASSERT_EQ(corner.size(), 2u);
    EXPECT_NEAR(dot(corner[0].place.normal, outwards), -1.0, 1e-12);
    EXPECT_NEAR(corner[1].place.normal[2], -1.0, 1e-12);
  }
  EXPECT_GT(rims, 2000);
}

// A silo: the cone of a hopper under a cylinder is one surface with it at the seam outside, and a corner inside.
TEST(WallSurfaces, AHopperUnderACylinder) {
  const std::vector<Wall<3>> silo{frustum_wall({{0, 0, 0}}, {{0, 0, 5}}, 3.0, 3.0),
                                  frustum_wall({{0, 0, -2}}, {{0, 0, 0}}, 1.0, 3.0)};
  for (int k = 0; k < 200; ++k) {
    const double turn = 0.0314 * k;
    const Vec<3> outwards{{std::cos(turn), std::sin(turn), 0.0}};
    const auto at = [&](double off, double z) { return Vec<3>(outwards * off + Vec<3>{{0, 0, z}}); };
    EXPECT_EQ(acting_touches(silo, at(3.49, 0.01), sphere_radius, sphere_radius).size(), 1u);
    EXPECT_EQ(acting_touches(silo, at(3.49, -0.01), sphere_radius, sphere_radius).size(), 1u);
    EXPECT_EQ(acting_touches(silo, at(3.0 + 0.49 * std::cos(0.3), -0.49 * std::sin(0.3)), sphere_radius, sphere_radius)
                  .size(),
              1u);
    // Inside both push where both are near: the corner opens by 135 degrees, so its middle is r / sin(67.5) away.
    const double off = 0.49;
    const double up_there = off * std::tan(std::numbers::pi / 8.0);
    EXPECT_EQ(acting_touches(silo, at(3.0 - off, up_there), sphere_radius, sphere_radius).size(), 2u);
    EXPECT_EQ(acting_touches(silo, at(3.0 - off, up_there + 0.3), sphere_radius, sphere_radius).size(), 1u);
  }
}

// Around a convex body of facets one contact acts everywhere, the nearest.
TEST(WallSurfaces, AConvexBody) {
  // An octahedron whose facets are cut in four, and pushed out to a sphere of sphere_radius 1.
  std::vector<std::array<Vec<3>, 3>> facets;
  const auto out = [](const Vec<3>& v) { return Vec<3>(v * (1.0 / magnitude(v))); };
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        std::vector<std::array<Vec<3>, 3>> part{{{{{x, 0, 0}}, {{0, y, 0}}, {{0, 0, z}}}}};
        for (int level = 0; level < 2; ++level) {
          std::vector<std::array<Vec<3>, 3>> finer;
          for (const auto& [a, b, c] : part) {
            const Vec<3> p = out(a + b), q = out(b + c), r = out(c + a);
            finer.insert(finer.end(), {{a, p, r}, {p, b, q}, {r, q, c}, {p, q, r}});
          }
          part = finer;
        }
        facets.insert(facets.end(), part.begin(), part.end());
      }
    }
  }
  const auto walls = walls_of_triangles(facets);
  ASSERT_EQ(walls.size(), 128u);
  Draws draws(13);
  for (int k = 0; k < 3000; ++k) {
    const Vec<3> centre = draws.direction() * draws.number(1.3, 1.5);
    const double least = height_over_all(walls, centre);
    const auto acting = acting_touches(walls, centre, sphere_radius, 1.2 * sphere_radius);
    if (least >= 1.2 * sphere_radius) continue;
    ASSERT_EQ(acting.size(), 1u) << k;
    EXPECT_NEAR(acting[0].place.height, least, 1e-12);
  }
}

// At a seam the displacements of the contact that acted pass on to the one that acts, once; one that spins about the
// normal keeps its twist though the contacts beside it have none.
TEST(WallSurfaces, DisplacementsPassOn) {
  const auto walls = walls_of_triangles({{{{{-1, -1, 0}}, {{1, -1, 0}}, {{0, 1, 0}}}},
                                         {{{{1, -1, 0}}, {{2, 1, 0}}, {{0, 1, 0}}}},
                                         {{{{-1, -1, 0}}, {{0, 1, 0}}, {{-2, 1, 0}}}}});
  const auto now = testing::standing(walls);
  const auto passed = [&](double x, std::vector<WallPair<3>> row) {
    WallContacts<3> contacts;
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      const Vec<3> from_point = Vec<3>{{x, 0.0, 0.45}} - now[w].point;
      contacts.add(w, w, from_point, above(walls[w], now[w], from_point));
    }
    contacts.join(walls, now, sphere_radius);
    pass_on_displacements(contacts, row.data());
    return row;
  };
  std::vector<WallPair<3>> row(3);
  row[0].slip = {{1, 2, 0}};
  row[0].roll = {{3, 4, 0}};
  row[0].twist = 5.0;
  row = passed(0.6, row);  // over the second triangle
  EXPECT_EQ(row[1].slip, (Vec<3>{{1, 2, 0}}));
  EXPECT_EQ(row[1].roll, (Vec<3>{{3, 4, 0}}));
  EXPECT_EQ(row[1].twist, 5.0);
  EXPECT_EQ(row[0].slip, (Vec<3>{}));
  EXPECT_EQ(row[0].twist, 0.0);
  row[1].slip = row[1].roll = {};
  row = passed(0.6, row);
  EXPECT_EQ(row[1].twist, 5.0);
  row = passed(-0.6, row);
  EXPECT_EQ(row[2].twist, 5.0);
  EXPECT_EQ(row[1].twist, 0.0);
}

// A rectangle that stands on an endless floor: its lower edge is no end, and a sphere in the corner touches both.
TEST(WallSurfaces, ARectangleOnAFloor) {
  const std::vector<Wall<3>> walls{Wall<3>{.point = {}, .normal = {{0, 0, 1}}},
                                   rectangle_wall({{0, -2, 0}}, {{0, 4, 0}}, {{0, 0, 3}})};
  const auto corner = acting_touches(walls, {{0.49, 0.3, 0.49}}, sphere_radius, sphere_radius);
  ASSERT_EQ(corner.size(), 2u);
  EXPECT_NEAR(corner[1].place.normal[0], 1.0, 1e-15);
  // Beyond the end of the rectangle, over its lowest corner.
  const auto beyond = acting_touches(walls, {{0.1, 2.3, 0.49}}, sphere_radius, sphere_radius);
  ASSERT_EQ(beyond.size(), 2u);
  EXPECT_NEAR(beyond[1].place.normal[2], 0.0, 1e-15);
}

}  // namespace
}  // namespace repose
