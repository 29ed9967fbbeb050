// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/deposition/spheres_path.hpp"
#include "repose/methods/deposition/spheres_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace repose::deposition::spheres {

/// How a sphere moves on from a place: the steepest way down that enters none of its supports. On none it falls, on one
/// it rolls straight down, on two it rolls about the line of their centres.
struct Motion {
  int supports = 0;         ///< that it keeps touching
  std::array<int, 2> on{};  ///< which of the supports touched
  Vec<3> direction{};       ///< unit vector
  double slope = -1.0;      ///< sine of the angle by which the direction points down, >= 0; -1: no way down, at rest
  bool rest() const { return slope < 0.0; }
};

/// The supports at a place, and which ways out are free of them.
class Surroundings {
 public:
  Surroundings(const Touched& touched, const Vec<3>& place, double tolerance)
      : count(touched.count), tolerance_(tolerance) {
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      normals_[i] = touched[k].normal(place);
      rates_[i] = touched[k].flat() ? 0.0 : 1.0 / touched[k].reach;
    }
  }

  const int count;
  const Vec<3>& normal(int k) const { return normals_[static_cast<std::size_t>(k)]; }

  /// The curvature [1/L] of the circle on which a sphere rolls on one or two supports, towards the outside.
  Vec<3> curvature(int k) const { return normal(k) * rate(k); }
  Vec<3> curvature(int j, int k) const {
    const double c = dot(normal(j), normal(k));
    return (normal(j) * (rate(j) - c * rate(k)) + normal(k) * (rate(k) - c * rate(j))) * (1.0 / (1.0 - c * c));
  }

  /// Whether a way enters no support; where it only touches one, whether it bends away from it too.
  bool free(const Vec<3>& direction, const Vec<3>& curved) const {
    constexpr double rounding = 1e-9;
    for (int k = 0; k < count; ++k) {
      const double away = dot(normal(k), direction);
      if (away < -tolerance_) return false;
      const double bent = dot(normal(k), curved);
      if (away <= tolerance_ && bent - rate(k) > rounding * (std::abs(bent) + rate(k))) return false;
    }
    return true;
  }

 private:
  double rate(int k) const { return rates_[static_cast<std::size_t>(k)]; }

  double tolerance_;
  std::array<Vec<3>, Touched::most> normals_;
  std::array<double, Touched::most> rates_;  // [1/L] curvatures of the supports for the moving centre
};

/// The motion from a place. The projection of gravity on the directions that enter no support is unique and lies on at
/// most two supports. Where level ways out of an unstable balance exist (exactly on top of a sphere, or above the line
/// of two), the first along +x, -x, +y, -y is taken.
inline Motion steepest_descent(const Touched& touched, const Vec<3>& place, double tolerance) {
  constexpr double level = 1e-12;  // a slope up to this is none
  const Surroundings at(touched, place, tolerance);
  const auto from_upright = [](const Vec<3>& n) { return std::sqrt(n[0] * n[0] + n[1] * n[1]); };
  if (const Vec<3> down{{0.0, 0.0, -1.0}}; at.free(down, {})) return {0, {}, down, 1.0};
  for (int k = 0; k < at.count; ++k) {
    const auto& n = at.normal(k);
    const double aside = from_upright(n);
    if (!(n[2] > 0.0) || aside == 0.0) continue;
    const Vec<3> direction{{n[0] / aside * n[2], n[1] / aside * n[2], -aside}};
    if (at.free(direction, at.curvature(k))) return {1, {k, 0}, direction, aside};
  }
  Motion best;
  for (int j = 0; j < at.count; ++j) {
    for (int k = j + 1; k < at.count; ++k) {
      const Vec<3> both = cross(at.normal(j), at.normal(k));
      const double size = magnitude(both);
      if (size < grazing) continue;  // opposite each other
      Vec<3> direction = both * (1.0 / size);
      const bool falls = std::abs(direction[2]) > level;
      const bool turned =
          falls ? direction[2] > 0.0 : direction[0] < 0.0 || (direction[0] == 0.0 && direction[1] < 0.0);
      if (turned) direction = -direction;
      const double slope = std::max(0.0, -direction[2]);
      if (slope <= best.slope) continue;
      const Vec<3> curved = at.curvature(j, k);
      if (at.free(direction, curved)) {
        best = {2, {j, k}, direction, slope};
      } else if (!falls && at.free(-direction, curved)) {
        best = {2, {j, k}, -direction, slope};
      }
    }
  }
  for (int k = 0; k < at.count && best.rest(); ++k) {
    if (touched[k].flat() || from_upright(at.normal(k)) != 0.0) continue;
    for (const auto& direction :
         {Vec<3>{{1.0, 0.0, 0.0}}, Vec<3>{{-1.0, 0.0, 0.0}}, Vec<3>{{0.0, 1.0, 0.0}}, Vec<3>{{0.0, -1.0, 0.0}}}) {
      if (best.rest() && at.free(direction, at.curvature(k))) best = {1, {k, 0}, direction, 0.0};
    }
  }
  return best;
}

/// The arc of a sphere that rolls on one support, down to its equator.
inline Arc arc_on_one(const Support& on, const Vec<3>& place, const Vec<3>& direction, double radius,
                      double tolerance) {
  const Vec<3> from = on.normal(place);
  Arc arc{on.centre, on.reach, from, direction, radius, tolerance, {on, {}}};
  arc.end(-direction[2], from[2]);
  return arc;
}

/// The arc of a sphere that rolls on two supports, about the axis of the circle on which it touches both. It ends where
/// one of them no longer carries a part of the weight, and `leaves` is set to that one.
inline Arc arc_on_two(const Support& first, const Support& second, const Vec<3>& place, const Vec<3>& direction,
                      double radius, double tolerance, const Support*& leaves) {
  // A plane comes second.
  const Vec<3> line = second.flat() ? second.centre : second.centre - first.centre;
  const double length2 = dot(line, line);
  const Vec<3> axis = line * (1.0 / std::sqrt(length2));
  const double along = second.flat() ? second.reach - dot(axis, first.centre)
                                     : 0.5 * (length2 + (first.reach - second.reach) * (first.reach + second.reach)) /
                                           std::sqrt(length2);
  const Vec<3> centre = first.centre + axis * along;
  const double size = std::sqrt(std::max(0.0, (first.reach - along) * (first.reach + along)));
  Vec<3> from = tangential(place - centre, axis);
  from *= 1.0 / magnitude(from);
  Vec<3> ahead = cross(axis, from);
  if (dot(ahead, direction) < 0.0) ahead = -ahead;
  Arc arc{centre, size, from, ahead, radius, tolerance, {first, second}};

  // Weight is carried by both in the parts n_1z - c n_2z and n_2z - c n_1z, with c = n_1 n_2, which does not change.
  // They are linear in the height.
  const Vec<3> n1 = first.normal(place);
  const Vec<3> n2 = second.normal(place);
  const double c = dot(n1, n2);
  const double rate1 = 1.0 / first.reach;
  const double rate2 = second.flat() ? 0.0 : 1.0 / second.reach;
  const auto drop_to_zero = [](double part, double rate) {
    return rate > 0.0 ? std::max(0.0, part) / rate : std::numeric_limits<double>::infinity();
  };
  const double drop1 = drop_to_zero(n1[2] - c * n2[2], rate1 - c * rate2);
  const double drop2 = drop_to_zero(n2[2] - c * n1[2], rate2 - c * rate1);
  leaves = drop1 < drop2 ? &first : &second;
  const double a = from[2];
  const double b = ahead[2];
  // A sphere below the middle of the circle cannot push on both.
  const double height = std::max(0.0, (place[2] - std::min(drop1, drop2) - centre[2]) / size);
  const double length = std::sqrt(a * a + b * b);
  const double across = std::sqrt(std::max(0.0, (length - height) * (length + height)));
  arc.end((a * height - b * across) / (length * length), (b * height + a * across) / (length * length));
  if (arc.sine < 0.0) arc.end(1.0, 0.0);  // it leaves at once, but for rounding
  return arc;
}

/// Three of the supports touched, by their numbers: those that carry the sphere, where three of more do.
inline std::array<std::int32_t, 3> chosen_supports(const Touched& touched, const Vec<3>& place) {
  std::array<int, 3> which{0, 1, 2};
  const auto carry = [&](int i, int j, int k) {
    const Vec<3> a = touched[i].normal(place);
    const Vec<3> b = touched[j].normal(place);
    const Vec<3> c = touched[k].normal(place);
    const double all = dot(a, cross(b, c));
    constexpr double rounding = 1e-9;
    return std::abs(all) > rounding && cross(b, c)[2] / all > -rounding && cross(c, a)[2] / all > -rounding &&
           cross(a, b)[2] / all > -rounding;
  };
  bool found = touched.count <= 3;
  for (int i = 0; i < touched.count && !found; ++i) {
    for (int j = i + 1; j < touched.count && !found; ++j) {
      for (int k = j + 1; k < touched.count && !found; ++k) {
        found = carry(i, j, k);
        if (found) which = {i, j, k};
      }
    }
  }
  std::array<std::int32_t, 3> numbers{nothing, nothing, nothing};
  for (std::size_t k = 0; k < 3; ++k) {
    if (which[k] < touched.count) numbers[k] = touched[which[k]].number;
  }
  return numbers;
}

}  // namespace repose::deposition::spheres
