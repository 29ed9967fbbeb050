// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "support/walls_3d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {
namespace {

using testing::Draws;

AboveWall<3> shortest_line(const Wall<3>& wall, const Vec<3>& centre) {
  return above(wall, wall_now(wall, {}, 0.0), Vec<3>(centre - wall.point));
}
bool ends_there(const Wall<3>& wall, const Vec<3>& centre) {
  return beyond_end(wall, wall_now(wall, {}, 0.0), Vec<3>(centre - wall.point));
}

/// The least value of a function with one valley in [low, high], and where it is, by golden section.
struct Valley {
  double place, value;
};
template <class Function>
Valley valley(double low, double high, const Function& of) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  std::array<Valley, 4> at{};  // the ends, and two places between them
  const auto value_at = [&](double place) { return Valley{place, of(place)}; };
  at = {value_at(low), value_at(high - golden * (high - low)), value_at(low + golden * (high - low)), value_at(high)};
  for (int k = 0; k < 34; ++k) {
    if (at[1].value < at[2].value) {
      at = {at[0], value_at(at[2].place - golden * (at[2].place - at[0].place)), at[1], at[2]};
    } else {
      at = {at[1], at[2], value_at(at[1].place + golden * (at[3].place - at[1].place)), at[3]};
    }
  }
  return *std::min_element(at.begin(), at.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
}

/// The distance from a place to a parallelogram (or half of it: a triangle) by search over its points. The search ends
/// within 1e-7 of the nearest one, or at the end of its range, so that the distance is within 1e-13.
double searched_distance(const Vec<3>& corner, const Vec<3>& a, const Vec<3>& b, bool triangle, const Vec<3>& place) {
  return valley(0.0, 1.0,
                [&](double s) {
                  return valley(0.0, triangle ? 1.0 - s : 1.0,
                                [&](double t) { return magnitude(Vec<3>(corner + a * s + b * t - place)); })
                      .value;
                })
      .value;
}

/// How far [fractions of the sides] a place in the plane of a parallelogram is outside it.
double outside(const Vec<3>& corner, const Vec<3>& a, const Vec<3>& b, bool triangle, const Vec<3>& place) {
  const Vec<3> normal = cross(a, b);
  const Vec<3> from_corner = place - corner;
  const double s = dot(cross(from_corner, b), normal) / squared(normal);
  const double t = dot(cross(a, from_corner), normal) / squared(normal);
  return std::max({-s, -t, triangle ? s + t - 1.0 : std::max(s, t) - 1.0});
}

// The direction points from a point of the wall at that distance, so a right distance makes it right too.
TEST(Walls3d, FacesEdgesAndCorners) {
  Draws draws(1);
  int faces = 0, edges = 0;
  for (int k = 0; k < 100; ++k) {
    const bool triangle = k % 2 == 0;
    const Vec<3> corner = draws.vector(1.0);
    const Vec<3> normal = draws.direction();
    const Vec<3> a = triangle ? draws.vector(1.0) : any_perpendicular(normal) * draws.number(0.2, 1.0);
    const Vec<3> b = triangle ? draws.vector(1.0) : cross(normal, a) * draws.number(0.5, 2.0);
    const auto wall = triangle ? triangle_wall(corner, corner + a, corner + b) : rectangle_wall(corner, a, b);
    const double unit = std::sqrt(area(wall));
    EXPECT_NEAR(area(wall), magnitude(cross(a, b)) * (triangle ? 0.5 : 1.0), 1e-14);
    for (int l = 0; l < 4; ++l) {
      const Vec<3> place = wall.point + draws.vector(1.3 * unit);
      const auto found = shortest_line(wall, place);
      ASSERT_NEAR(found.height, searched_distance(corner, a, b, triangle, place), 1e-9) << k;
      EXPECT_NEAR(magnitude(found.normal), 1.0, 1e-12);
      const Vec<3> nearest = place - found.normal * found.height;
      EXPECT_NEAR(dot(Vec<3>(nearest - wall.point), wall.normal), 0.0, 1e-12) << k;
      EXPECT_LT(outside(corner, a, b, triangle, nearest), 1e-9) << k;
      const double tilt = magnitude(cross(found.normal, wall.normal));
      ++(ends_there(wall, place) ? edges : faces);
      EXPECT_EQ(ends_there(wall, place), tilt > 1e-6) << k;
    }
  }
  EXPECT_GT(faces, 50);
  EXPECT_GT(edges, 200);
}

TEST(Walls3d, RectangleByRegions) {
  const auto wall = rectangle_wall({{0, 0, 0}}, {{4, 0, 0}}, {{0, 2, 0}});
  EXPECT_EQ(wall.normal, (Vec<3>{{0, 0, 1}}));
  EXPECT_DOUBLE_EQ(shortest_line(wall, {{1, 1.9, 0.4}}).height, 0.4);
  EXPECT_EQ(shortest_line(wall, {{1, 1.9, -0.4}}).normal, (Vec<3>{{0, 0, -1}}));
  const auto edge = shortest_line(wall, {{1, 2.3, -0.4}});  // 3, 4, 5 beside the edge
  EXPECT_NEAR(edge.height, 0.5, 1e-15);
  EXPECT_NEAR(magnitude(Vec<3>(edge.normal - Vec<3>{{0, 0.6, -0.8}})), 0.0, 1e-14);
  const auto corner = shortest_line(wall, {{-2, -3, 6}});  // 2, 3, 6, 7
  EXPECT_NEAR(corner.height, 7.0, 1e-14);
  EXPECT_FALSE(ends_there(wall, {{0, 0, 1}}));  // above the edge is above the face
  EXPECT_TRUE(ends_there(wall, {{-1e-9, 0, 1}}));
}

TEST(Walls3d, TriangleByRegions) {
  for (const auto& [a, b, c] : {std::array<Vec<3>, 3>{{{{0, 0, 0}}, {{4, 0, 0}}, {{0, 3, 0}}}},
                                std::array<Vec<3>, 3>{{{{0, 3, 0}}, {{0, 0, 0}}, {{4, 0, 0}}}},
                                std::array<Vec<3>, 3>{{{{4, 0, 0}}, {{0, 3, 0}}, {{0, 0, 0}}}}}) {
    const auto wall = triangle_wall(a, b, c);
    EXPECT_NEAR(wall.normal[2], 1.0, 1e-15);
    EXPECT_NEAR(shortest_line(wall, {{1, 1, 0.7}}).height, 0.7, 1e-15);
    // Beside the long edge, whose direction outwards is (3, 4) / 5.
    const auto edge = shortest_line(wall, {{2.0 + 0.6 * 0.3, 1.5 + 0.8 * 0.3, 0.4}});
    EXPECT_NEAR(edge.height, 0.5, 1e-14);
    EXPECT_NEAR(magnitude(Vec<3>(edge.normal - Vec<3>{{0.36, 0.48, 0.8}})), 0.0, 1e-13);
    EXPECT_NEAR(shortest_line(wall, {{-2, -3, 6}}).height, 7.0, 1e-14);
    EXPECT_NEAR(shortest_line(wall, {{6, -3, 6}}).height, 7.0, 1e-14);
  }
}

// A sphere in a cylinder is pushed inwards, one outside outwards; beyond its end the rim pushes.
TEST(Walls3d, Cylinder) {
  const Vec<3> axis = Vec<3>{{2, -1, 2}} * (1.0 / 3.0);
  const Vec<3> outwards = Vec<3>{{1, 2, 0}} * (1.0 / std::sqrt(5.0));
  const Vec<3> start{{5, 6, 7}};
  const auto wall = frustum_wall(start, start + axis * 4.0, 1.5, 1.5);
  EXPECT_NEAR(area(wall), 2.0 * std::numbers::pi * 1.5 * 4.0, 1e-13);
  const auto check = [&](double along, double off, double height, const Vec<3>& direction) {
    const auto found = shortest_line(wall, start + axis * along + outwards * off);
    EXPECT_NEAR(found.height, height, 1e-14) << along << " " << off;
    EXPECT_NEAR(magnitude(Vec<3>(found.normal - direction)), 0.0, 1e-13) << along << " " << off;
  };
  check(3.9, 1.1, 0.4, -outwards);
  check(0.1, 1.9, 0.4, outwards);
  check(4.3, 1.1, 0.5, outwards * -0.8 + axis * 0.6);
  check(-0.4, 1.8, 0.5, outwards * 0.6 - axis * 0.8);
  // A sphere on the axis touches all around, and feels one place of the wall, the same each time.
  const auto middle = shortest_line(wall, start + axis * 2.0);
  EXPECT_NEAR(middle.height, 1.5, 1e-14);
  EXPECT_NEAR(dot(middle.normal, axis), 0.0, 1e-14);
  EXPECT_NEAR(magnitude(middle.normal), 1.0, 1e-14);
  EXPECT_EQ(shortest_line(wall, start + axis * 2.0).normal, middle.normal);
  // A centre on the wall has a direction as well.
  const auto on_wall = shortest_line(wall, start + axis * 2.0 + outwards * 1.5);
  EXPECT_NEAR(on_wall.height, 0.0, 1e-14);
  EXPECT_NEAR(std::fabs(dot(on_wall.normal, outwards)), 1.0, 1e-13);
}

// A cone with its tip at 0 that opens upwards with half an angle alpha: a place at (r, z) is |r cos - z sin| away from
// it, outside with a normal (cos, -sin), inside with its opposite, and next to the tip r^2 + z^2 where the foot of that
// line is not on the cone.
TEST(Walls3d, Cone) {
  for (const double alpha : {0.1, 0.5, std::numbers::pi / 4.0, 1.4}) {
    const double sine = std::sin(alpha), cosine = std::cos(alpha);
    const auto cone = frustum_wall({{0, 0, 0}}, {{0, 0, 10.0 * cosine}}, 0.0, 10.0 * sine);
    EXPECT_NEAR(area(cone), std::numbers::pi * 10.0 * sine * 10.0, 1e-11);
    for (const double turn : {0.3, 2.0, 4.5}) {
      const Vec<3> outwards{{std::cos(turn), std::sin(turn), 0.0}};
      const Vec<3> upwards{{0, 0, 1}};
      const Vec<3> normal = outwards * cosine - upwards * sine;
      const Vec<3> foot = outwards * (4.0 * sine) + upwards * (4.0 * cosine);
      const double free = 4.0 * sine / cosine;  // from there the axis is this far away
      for (const double height : {0.3 * free, 0.9 * free}) {
        const auto inside = shortest_line(cone, foot - normal * height);
        EXPECT_NEAR(inside.height, height, 1e-13);
        EXPECT_NEAR(magnitude(Vec<3>(inside.normal + normal)), 0.0, 1e-12);
        const auto outside = shortest_line(cone, foot + normal * height);
        EXPECT_NEAR(outside.height, height, 1e-13);
        EXPECT_NEAR(magnitude(Vec<3>(outside.normal - normal)), 0.0, 1e-12);
      }
      // On the axis at height z the cone is z sin(alpha) away on all sides.
      EXPECT_NEAR(shortest_line(cone, {{0, 0, 6.0}}).height, 6.0 * sine, 1e-13);
      const Vec<3> below = outwards * 0.3 - upwards * (0.3 * sine / cosine + 0.4);
      const auto tip = shortest_line(cone, below);
      EXPECT_NEAR(tip.height, magnitude(below), 1e-14);
      EXPECT_NEAR(magnitude(Vec<3>(tip.normal * tip.height - below)), 0.0, 1e-14);
      EXPECT_TRUE(ends_there(cone, below));
      const auto rim = shortest_line(cone, outwards * (10.0 * sine) + upwards * (10.0 * cosine) +
                                               outwards * (0.3 * sine) + upwards * (0.3 * cosine));
      EXPECT_NEAR(rim.height, 0.3, 1e-13);
      EXPECT_NEAR(dot(rim.normal, outwards), sine, 1e-12);
    }
  }
}

TEST(Walls3d, Ring) {
  const auto ring = ring_wall({{1, 1, 2}}, {{0, 0, -3}}, 1.0, 3.0);
  EXPECT_NEAR(area(ring), 8.0 * std::numbers::pi, 1e-13);
  EXPECT_DOUBLE_EQ(shortest_line(ring, {{3, 1, 2.5}}).height, 0.5);
  EXPECT_EQ(shortest_line(ring, {{3, 1, 2.5}}).normal, (Vec<3>{{0, 0, 1}}));
  EXPECT_EQ(shortest_line(ring, {{3, 1, 1.5}}).normal, (Vec<3>{{0, 0, -1}}));
  EXPECT_NEAR(shortest_line(ring, {{1, 1.7, 2.4}}).height, 0.5, 1e-15);  // within the hole
  EXPECT_NEAR(shortest_line(ring, {{1, 1, 2.0}}).height, 1.0, 1e-15);
  EXPECT_NEAR(shortest_line(ring, {{4.3, 1, 2.4}}).height, 0.5, 1e-15);
}

// By search over the whole surface of revolution.
TEST(Walls3d, FrustumBySearch) {
  Draws draws(3);
  for (int k = 0; k < 60; ++k) {
    const Vec<3> start = draws.vector(1.0);
    const Vec<3> axis = draws.direction();
    const double length = draws.number(0.1, 2.0);
    const double first = k % 5 == 0 ? 0.0 : draws.number(0.0, 1.0);
    const double second = k % 7 == 0 ? first : draws.number(0.0, 1.0);
    if (first + second == 0.0) continue;
    const auto wall = frustum_wall(start, start + axis * length, first, second);
    const Vec<3> u = any_perpendicular(axis), v = cross(axis, u);
    for (int l = 0; l < 5; ++l) {
      const Vec<3> place = start + axis * (0.5 * length) + draws.vector(1.5);
      const auto at_angle = [&](double angle) {
        const Vec<3> outwards = u * std::cos(angle) + v * std::sin(angle);
        return valley(0.0, 1.0,
                      [&](double s) {
                        return magnitude(
                            Vec<3>(start + axis * (s * length) + outwards * (first + s * (second - first)) - place));
                      })
            .value;
      };
      double best = 0.0;
      for (int n = 1; n < 16; ++n) {
        if (at_angle(0.125 * std::numbers::pi * n) < at_angle(best)) best = 0.125 * std::numbers::pi * n;
      }
      const double searched = valley(best - 0.126 * std::numbers::pi, best + 0.126 * std::numbers::pi, at_angle).value;
      const auto found = shortest_line(wall, place);
      ASSERT_NEAR(found.height, searched, 1e-9) << k;
      EXPECT_NEAR(magnitude(found.normal), 1.0, 1e-12);
      EXPECT_NEAR(shortest_line(wall, place - found.normal * found.height).height, 0.0, 1e-12);
    }
  }
}

// A wall that has turned is as one that was made of turned corners.
TEST(Walls3d, RotationTurnsTheWholeWall) {
  Draws draws(4);
  for (int k = 0; k < 60; ++k) {
    const Vec<3> corner = draws.vector(2.0);
    const Vec<3> normal = draws.direction();
    const Vec<3> a = any_perpendicular(normal) * draws.number(0.5, 1.0);
    const Vec<3> b = cross(normal, a) * draws.number(0.5, 2.0);
    const Vec<3> centre = draws.vector(2.0), axis = draws.direction();
    const double angle = draws.number(-7.0, 7.0);
    const auto turned_place = [&](const Vec<3>& place) {
      return Vec<3>(centre + rotated(Vec<3>(place - centre), axis, angle));
    };
    const auto make = [&](const auto& place, const auto& arrow) {
      if (k % 3 == 0) return triangle_wall(place(corner), place(corner + a), place(corner + b));
      if (k % 3 == 1) return rectangle_wall(place(corner), arrow(a), arrow(b));
      return frustum_wall(place(corner), place(corner + a), 0.3, 0.7);
    };
    const auto turned_arrow = [&](const Vec<3>& arrow) { return rotated(arrow, axis, angle); };
    const auto same = [](const Vec<3>& it) { return it; };
    auto wall = make(same, same);
    const auto expected = make(turned_place, turned_arrow);
    wall.motion.kind = WallMotion<3>::Kind::rotation;
    wall.motion.centre = centre;
    wall.motion.axis = axis;
    const auto now = wall_now(wall, {.displacement = angle, .speed = 2.0}, 0.0);
    for (int l = 0; l < 10; ++l) {
      const Vec<3> place = expected.point + draws.vector(2.0);
      const auto found = above(wall, now, Vec<3>(place - now.point));
      const auto wanted = shortest_line(expected, place);
      ASSERT_NEAR(found.height, wanted.height, 1e-12) << k;
      EXPECT_NEAR(magnitude(Vec<3>(found.normal - wanted.normal)), 0.0, 1e-9) << k;
      // Where it touches, the surface moves as a rigid body does.
      const Vec<3> nearest = place - found.normal * found.height;
      const Vec<3> velocity = now.surface_velocity(Vec<3>(nearest - now.point), found.normal);
      EXPECT_NEAR(magnitude(Vec<3>(velocity - cross(axis * 2.0, nearest - centre))), 0.0, 1e-12);
      // No point of it has moved farther than said: the nearest one, at the start and now.
      const Vec<3> before = centre + rotated(Vec<3>(nearest - centre), axis, -angle);
      EXPECT_LE(magnitude(Vec<3>(nearest - before)), farthest_moved(wall, angle) * (1.0 + 1e-12));
    }
  }
}

// A drum that turns about its own axis stays where it is, to the bit, and so do its round ends.
TEST(Walls3d, TurningInItselfMovesNothing) {
  const Vec<3> start{{1, 2, 3}};
  const Vec<3> axis = Vec<3>{{1, 2, -2}} * (1.0 / 3.0);
  for (auto wall : {frustum_wall(start, start + axis * 3.0, 1.0, 2.0), disc_wall(start + axis * 3.0, axis, 2.0),
                    disc_wall(start, -axis, 1.0), ring_wall(start, axis, 0.5, 1.0)}) {
    wall.motion.kind = WallMotion<3>::Kind::rotation;
    wall.motion.centre = start + axis * 7.0;
    wall.motion.axis = axis;
    EXPECT_TRUE(turns_in_itself(wall));
    EXPECT_EQ(farthest_moved(wall, 3.0), 0.0);
    const auto now = wall_now(wall, {.displacement = 12.3, .speed = 0.7}, 0.0);
    EXPECT_EQ(now.point, wall.point);
    EXPECT_EQ(now.normal, wall.normal);
    EXPECT_EQ(now.side, wall.shape.side);
    const Vec<3> place = wall.point + any_perpendicular(axis) * 0.8;
    const Vec<3> velocity = now.surface_velocity(Vec<3>(place - now.point), axis);
    EXPECT_NEAR(magnitude(Vec<3>(velocity - cross(axis * 0.7, any_perpendicular(axis) * 0.8))), 0.0, 1e-14);
    // About another axis, or one beside its own, it moves.
    auto other = wall;
    other.motion.axis = Vec<3>{{0, 0, 1}};
    EXPECT_FALSE(turns_in_itself(other));
    other = wall;
    other.motion.centre += any_perpendicular(axis) * 0.1;
    EXPECT_FALSE(turns_in_itself(other));
    EXPECT_NEAR(farthest_moved(other, 2.0), 2.0 * (0.1 + wall.half_length), 1e-14);
  }
  // A plane too, about any place; a rectangle does not.
  Wall<3> plane{.normal = axis};
  plane.motion.kind = WallMotion<3>::Kind::rotation;
  plane.motion.axis = axis;
  plane.motion.centre = {{4, 4, 4}};
  EXPECT_TRUE(turns_in_itself(plane));
  EXPECT_EQ(farthest_moved(plane, 1.0), 0.0);
  auto square = rectangle_wall({{-1, -1, 0}}, {{2, 0, 0}}, {{0, 2, 0}});
  square.motion.kind = WallMotion<3>::Kind::rotation;
  square.motion.axis = {{0, 0, 1}};
  EXPECT_FALSE(turns_in_itself(square));
}

}  // namespace
}  // namespace repose
