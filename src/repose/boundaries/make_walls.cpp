// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/boundaries/make_walls.hpp"

#include <algorithm>

namespace repose {

namespace {

using Kind = WallShape<3>::Kind;

Vec<3> direction_of(const Vec<3>& vector) { return vector * (1.0 / magnitude(vector)); }

/// The part of a vector perpendicular to a unit vector, as a unit vector.
Vec<3> flat_direction(const Vec<3>& vector, const Vec<3>& unit) {
  return direction_of(tangential(direction_of(vector), unit));
}

/// A wall about `axis` whose line has these ends.
Wall<3> about(const Vec<3>& point, const Vec<3>& axis, const Vec<2>& from, const Vec<2>& to) {
  Wall<3> wall{.point = point, .normal = direction_of(axis)};
  wall.half_length = std::max(magnitude(from), magnitude(to));
  wall.shape = {.kind = Kind::frustum, .side = any_perpendicular(wall.normal), .corners = {from, to, {}}};
  return wall;
}

}  // namespace

Wall<3> disc_wall(const Vec<3>& centre, const Vec<3>& normal, double radius) {
  Wall<3> wall{.point = centre, .normal = direction_of(normal), .half_length = radius};
  wall.shape.side = any_perpendicular(wall.normal);
  return wall;
}

Wall<3> rectangle_wall(const Vec<3>& corner, const Vec<3>& side_a, const Vec<3>& side_b) {
  const Vec<2> half{{0.5 * magnitude(side_a), 0.5 * magnitude(side_b)}};
  Wall<3> wall{.point = corner + (side_a + side_b) * 0.5, .normal = direction_of(cross(side_a, side_b))};
  wall.half_length = magnitude(half);
  wall.shape = {.kind = Kind::rectangle, .side = flat_direction(side_a, wall.normal), .corners = {half, {}, {}}};
  return wall;
}

Wall<3> triangle_wall(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  // The sides that meet at the largest angle fix the normal best.
  const std::array<Vec<3>, 3> sides{b - a, c - b, a - c};
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (squared(sides[k]) > squared(sides[longest])) longest = k;
  }
  const Vec<3> normal = direction_of(cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]));
  Wall<3> wall{.point = (a + b + c) * (1.0 / 3.0), .normal = normal, .half_length = 0.0};
  wall.shape = {.kind = Kind::triangle, .side = flat_direction(sides[longest], normal)};
  const Vec<3> across = cross(wall.normal, wall.shape.side);
  std::size_t k = 0;
  for (const auto& corner : {a, b, c}) {
    const Vec<3> from_point = corner - wall.point;
    wall.shape.corners[k++] = {{dot(from_point, wall.shape.side), dot(from_point, across)}};
    wall.half_length = std::max(wall.half_length, magnitude(from_point));
  }
  return wall;
}

Wall<3> frustum_wall(const Vec<3>& from, const Vec<3>& to, double radius_from, double radius_to) {
  const Vec<3> axis = to - from;
  const double half = 0.5 * magnitude(axis);
  return about(from + axis * 0.5, axis, {{radius_from, -half}}, {{radius_to, half}});
}

Wall<3> ring_wall(const Vec<3>& centre, const Vec<3>& normal, double inner_radius, double outer_radius) {
  return about(centre, normal, {{inner_radius, 0.0}}, {{outer_radius, 0.0}});
}

std::vector<Wall<3>> surface_walls(const std::vector<Vec<3>>& vertices,
                                   const std::vector<std::array<std::uint32_t, 3>>& facets) {
  std::vector<Wall<3>> walls;
  walls.reserve(facets.size());
  for (const auto& facet : facets) {
    walls.push_back(triangle_wall(vertices[facet[0]], vertices[facet[1]], vertices[facet[2]]));
  }
  return walls;
}

double area(const Wall<3>& wall) { return area_of(wall.shape, wall.half_length); }

}  // namespace repose
