// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/boundaries/wall_shape.hpp"

#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace repose {

namespace {

using Kind = WallShape<3>::Kind;

constexpr std::array<std::pair<Kind, std::string_view>, 4> shape_names{
    {{Kind::disc, "disc"}, {Kind::rectangle, "rectangle"}, {Kind::triangle, "triangle"}, {Kind::frustum, "frustum"}}};

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The place of the line from a to b that is nearest to p, as a fraction of the line.
double nearest_part(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p) {
  const Vec<2> along = b - a;
  return std::clamp(dot(Vec<2>(p - a), along) / dot(along, along), 0.0, 1.0);
}

bool inside_triangle(const std::array<Vec<2>, 3>& corners, const Vec<2>& place) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& corner = corners[k];
    if (cross(corners[(k + 1) % 3] - corner, place - corner) < 0.0) return false;
  }
  return true;
}

bool inside_rectangle(const Vec<2>& corner, const Vec<2>& place) {
  return std::fabs(place[0]) <= corner[0] && std::fabs(place[1]) <= corner[1];
}

Vec<2> nearest_on_edges(const std::array<Vec<2>, 3>& corners, const Vec<2>& place) {
  Vec<2> nearest{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& from = corners[k];
    const auto& to = corners[(k + 1) % 3];
    const Vec<2> edge = from + (to - from) * nearest_part(from, to, place);
    const double distance2 = squared(Vec<2>(place - edge));
    if (distance2 >= least) continue;
    least = distance2;
    nearest = edge;
  }
  return nearest;
}

NearestOnShape line_along(const Vec<3>& from_end) {
  const double distance = magnitude(from_end);
  return {distance, from_end * (1.0 / std::max(distance, std::numeric_limits<double>::min())), true};
}

/// The shortest line from a flat shape: its face where the place lies above or below it, else its edge.
NearestOnShape nearest_on_flat(const WallShape<3>& shape, const Vec<3>& normal, const Vec<3>& side,
                               const Vec<3>& from_point) {
  const Vec<3> across = cross(normal, side);
  const double height = dot(from_point, normal);
  const Vec<2> place{{dot(from_point, side), dot(from_point, across)}};
  const auto& corners = shape.corners;
  const bool triangle = shape.kind == Kind::triangle;
  if (triangle ? inside_triangle(corners, place) : inside_rectangle(corners[0], place)) {
    if (height < 0.0) return {-height, -normal, false};
    return {height, normal, false};
  }
  const Vec<2> edge = triangle ? nearest_on_edges(corners, place)
                               : Vec<2>{{std::clamp(place[0], -corners[0][0], corners[0][0]),
                                         std::clamp(place[1], -corners[0][1], corners[0][1])}};
  const Vec<2> beside = place - edge;
  return line_along(side * beside[0] + across * beside[1] + normal * height);
}

/// The nearest point lies in the half-plane of the place and the axis, where the frustum is a straight line.
NearestOnShape nearest_on_frustum(const WallShape<3>& shape, const Vec<3>& axis, const Vec<3>& side,
                                  const Vec<3>& from_point) {
  const double along = dot(from_point, axis);
  const Vec<3> off_axis = from_point - axis * along;
  const double distance = magnitude(off_axis);
  const bool on_axis = distance <= std::numeric_limits<double>::min();
  const Vec<3> outwards = on_axis ? side : off_axis * (1.0 / distance);
  const auto& from = shape.corners[0];
  const Vec<2> line = shape.corners[1] - from;
  const Vec<2> place = Vec<2>{{distance, along}} - from;
  const double part = dot(place, line) / dot(line, line);
  if (part >= 0.0 && part <= 1.0) {
    const double height = cross(place, line) / magnitude(line);
    const Vec<2> facing = Vec<2>{{line[1], -line[0]}} * ((height < 0.0 ? -1.0 : 1.0) / magnitude(line));
    return {std::fabs(height), outwards * facing[0] + axis * facing[1], false};
  }
  const Vec<2> from_end = part < 0.0 ? place : Vec<2>(place - line);
  return line_along(outwards * from_end[0] + axis * from_end[1]);
}

/// Whether the path from one place to another goes through the line of a frustum, as both turn about the axis. The
/// squared distance from the axis, less that of the frustum at the same height, is a polynomial of second degree in the
/// fraction of the path.
bool passes_through_frustum(const WallShape<3>& shape, const Vec<3>& from, const Vec<3>& to) {
  const auto& low = shape.corners[0];
  const Vec<2> line = shape.corners[1] - low;
  const Vec<3> path = to - from;
  if (line[1] == 0.0) {  // flat
    const double height = from[2] - low[1];
    if (height == 0.0 || (height > 0.0) == (to[2] > low[1])) return false;
    const Vec<3> place = from - path * (height / path[2]);
    const double part = (std::sqrt(place[0] * place[0] + place[1] * place[1]) - low[0]) / line[0];
    return part >= 0.0 && part <= 1.0;
  }
  const auto within = [&](double fraction) {
    const double part = (from[2] + path[2] * fraction - low[1]) / line[1];
    return fraction > 0.0 && fraction <= 1.0 && part >= 0.0 && part <= 1.0;
  };
  const double slope = line[0] / line[1];
  const double radius = low[0] + slope * (from[2] - low[1]);  // of the frustum, at the height of the start
  const double opening = slope * path[2];
  const double a = path[0] * path[0] + path[1] * path[1] - opening * opening;
  const double half_b = from[0] * path[0] + from[1] * path[1] - radius * opening;
  const double c = from[0] * from[0] + from[1] * from[1] - radius * radius;
  const double root2 = half_b * half_b - a * c;
  if (c == 0.0 || !(root2 >= 0.0)) return false;
  const double q = -(half_b + std::copysign(std::sqrt(root2), half_b));
  return (a != 0.0 && within(q / a)) || (q != 0.0 && within(c / q));
}

}  // namespace

std::string_view shape_name(Kind kind) {
  for (const auto& [known, name] : shape_names) {
    if (known == kind) return name;
  }
  return "";
}

std::optional<Kind> shape_of_name(std::string_view name) {
  for (const auto& [kind, known] : shape_names) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

Vec<3> any_perpendicular(const Vec<3>& unit) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::fabs(unit[k]) < std::fabs(unit[least])) least = k;
  }
  Vec<3> axis{};
  axis[least] = 1.0;
  const Vec<3> flat = axis - unit * dot(axis, unit);
  return flat * (1.0 / magnitude(flat));
}

NearestOnShape nearest_on(const WallShape<3>& shape, const Vec<3>& normal, const Vec<3>& side,
                          const Vec<3>& from_point) {
  REPOSE_ASSERT(shape.kind != Kind::disc);
  if (shape.kind == Kind::frustum) return nearest_on_frustum(shape, normal, side, from_point);
  return nearest_on_flat(shape, normal, side, from_point);
}

bool passes_through(const WallShape<3>& shape, double half_length, const Vec<3>& from, const Vec<3>& to) {
  if (shape.kind == Kind::frustum) return passes_through_frustum(shape, from, to);
  if (from[2] == 0.0 || (from[2] > 0.0) == (to[2] > 0.0)) return false;
  const Vec<3> there = from + (to - from) * (from[2] / (from[2] - to[2]));
  const Vec<2> place{{there[0], there[1]}};
  if (shape.kind == Kind::triangle) return inside_triangle(shape.corners, place);
  if (shape.kind == Kind::rectangle) return inside_rectangle(shape.corners[0], place);
  return magnitude(place) <= half_length;
}

Vec<3> half_extent(const WallShape<3>& shape, double half_length, const Vec<3>& normal, const Vec<3>& side) {
  Vec<3> extent{};
  const Vec<3> across = cross(normal, side);
  const auto& corners = shape.corners;
  for (int k = 0; k < 3; ++k) {
    const double round = std::sqrt(std::max(0.0, 1.0 - normal[k] * normal[k]));  // of a circle of radius 1
    switch (shape.kind) {
      case Kind::disc:
        extent[k] = half_length * round;
        break;
      case Kind::rectangle:
        extent[k] = corners[0][0] * std::fabs(side[k]) + corners[0][1] * std::fabs(across[k]);
        break;
      case Kind::triangle:
        for (const auto& corner : corners) {
          extent[k] = std::max(extent[k], std::fabs(corner[0] * side[k] + corner[1] * across[k]));
        }
        break;
      case Kind::frustum:
        for (const auto& end : {corners[0], corners[1]}) {
          extent[k] = std::max(extent[k], std::fabs(end[1] * normal[k]) + end[0] * round);
        }
        break;
    }
  }
  return extent;
}

double area_of(const WallShape<3>& shape, double half_length) {
  const auto& corners = shape.corners;
  switch (shape.kind) {
    case Kind::disc:
      break;
    case Kind::rectangle:
      return 4.0 * corners[0][0] * corners[0][1];
    case Kind::triangle:
      return 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    case Kind::frustum:
      return std::numbers::pi * (corners[0][0] + corners[1][0]) * magnitude(Vec<2>(corners[1] - corners[0]));
  }
  return std::numbers::pi * half_length * half_length;
}

}  // namespace repose
