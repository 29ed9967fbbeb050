// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/make_walls.hpp"
#include "repose/boundaries/wall_contacts.hpp"
#include "repose/core/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace repose::testing {

/// Random numbers in the order of the calls.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * uniform(seed_, Purpose::release_position, next_++);
  }
  Vec<3> vector(double largest) {
    Vec<3> drawn;
    for (int k = 0; k < 3; ++k) drawn[k] = number(-largest, largest);
    return drawn;
  }
  Vec<3> direction() {
    while (true) {
      const Vec<3> drawn = vector(1.0);
      const double length = magnitude(drawn);
      if (length > 0.1 && length < 1.0) return drawn * (1.0 / length);
    }
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

/// A wall of one of the shapes, about as large as `size` [L], with its middle within `far` of the origin.
inline Wall<3> random_wall(Draws& draws, double size, double far) {
  const Vec<3> at = draws.vector(far);
  const Vec<3> normal = draws.direction();
  const Vec<3> side = any_perpendicular(normal);
  const double a = draws.number(0.3, 1.0) * size;
  const double b = draws.number(0.3, 1.0) * size;
  switch (static_cast<int>(draws.number(0.0, 5.0))) {
    case 0:
      return disc_wall(at, normal, a);
    case 1:
      return rectangle_wall(at, side * a, cross(normal, side) * b);
    case 2:
      return triangle_wall(at, at + draws.vector(size), at + draws.vector(size));
    case 3:
      return ring_wall(at, normal, 0.5 * std::min(a, b), std::max(a, b));
    default:
      return frustum_wall(at, at + normal * a, b, draws.number(0.0, 1.0) * size);
  }
}

inline std::vector<WallNow<3>> standing(const std::vector<Wall<3>>& walls) {
  std::vector<WallNow<3>> now;
  for (const auto& wall : walls) now.push_back(wall_now(wall, {}, 0.0));
  return now;
}

/// The touches that act on a sphere, of walls closer to its centre than `reach` [L].
inline std::vector<WallTouch<3>> acting_touches(const std::vector<Wall<3>>& walls, const Vec<3>& centre, double radius,
                                                double reach) {
  WallContacts<3> contacts;
  const auto now = standing(walls);
  for (std::uint32_t w = 0; w < walls.size(); ++w) {
    const Vec<3> from_point = centre - now[w].point;
    const auto place = above(walls[w], now[w], from_point);
    if (place.height < reach) contacts.add(w, w, from_point, place);
  }
  contacts.join(walls, now, radius);
  std::vector<WallTouch<3>> found;
  for (const auto& touch : contacts.all()) {
    if (contacts.acts(touch)) found.push_back(touch);
  }
  return found;
}

/// A square from (0, 0, 0) to (side, side, 0), cut into 2 + 2 `points` triangles by random points, each of which cuts
/// the triangle that it lies in.
inline std::vector<std::array<Vec<3>, 3>> cut_square(Draws& draws, double side, int points) {
  const Vec<3> a{{0, 0, 0}}, b{{side, 0, 0}}, c{{side, side, 0}}, d{{0, side, 0}};
  std::vector<std::array<Vec<3>, 3>> triangles{{a, b, c}, {a, c, d}};
  for (int k = 0; k < points; ++k) {
    const Vec<3> p{{draws.number(0.0, side), draws.number(0.0, side), 0.0}};
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto [q, r, s] = triangles[t];
      const auto left = [&](const Vec<3>& from, const Vec<3>& to) {
        return cross(Vec<3>(to - from), Vec<3>(p - from))[2] > 0.0;
      };
      if (!left(q, r) || !left(r, s) || !left(s, q)) continue;
      triangles[t] = {q, r, p};
      triangles.push_back({r, s, p});
      triangles.push_back({s, q, p});
      break;
    }
  }
  return triangles;
}

}  // namespace repose::testing
