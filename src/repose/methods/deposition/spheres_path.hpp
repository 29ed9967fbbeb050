// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/methods/deposition/spheres_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

/// The two paths of a sphere, a vertical line and an arc of a circle, and the first support that it meets on each.
namespace repose::deposition::spheres {

/// A falling sphere and its highest landing so far.
struct Fall {
  double x;       ///< [L]
  double y;       ///< [L]
  double radius;  ///< [L]
  double start;   ///< [L] height at which the fall starts
  Support on{};
  double height = -std::numeric_limits<double>::infinity();  ///< [L] of the centre where it lands

  REPOSE_FN void consider(const Vec<3>& centre, double other, std::int32_t number) {
    const double reach = radius + other;
    const double dx = x - centre[0];
    const double dy = y - centre[1];
    const double rise2 = reach * reach - dx * dx - dy * dy;
    if (!(rise2 > grazing * grazing * reach * reach)) return;
    const double top = centre[2] + std::sqrt(rise2);
    if (top < height || top > start + touching * reach) return;
    const Support support{centre, reach, number};
    if (top == height && !before(support, on)) return;
    on = support;
    height = top;
  }
};

/// The way of a rolling sphere, and what it meets first. Places are centre + radius (from cos(angle) + ahead
/// sin(angle)), with the angle ascending from 0 to a right angle at most. `turn` is the tangent of half an angle, so
/// that no angle is computed. The arc ends by itself where the sphere leaves a support.
struct Arc {
  Vec<3> centre;        ///< [L] of the circle
  double radius;        ///< [L] of the circle
  Vec<3> from;          ///< unit vector to the start
  Vec<3> ahead;         ///< unit vector of the motion at the start
  double own;           ///< [L] radius of the moving sphere
  double tolerance;     ///< sine up to which a motion into a support that is touched does not count
  Support on[2]{};      ///< what it rolls on; the second is nothing if it rolls on one
  Support left{};       ///< a support just left, which it does not meet at the start
  Support met{};        ///< nothing: the arc ends by itself
  double turn = 0.0;    ///< where it meets that, or ends
  double cosine = 1.0;  ///< of the same angle
  double sine = 0.0;

  Vec<3> place() const { return place(cosine, sine); }
  Vec<3> place(double c, double s) const { return centre + (from * c + ahead * s) * radius; }

  /// Sets the end of the arc. A later one may follow from what it meets.
  void end(double c, double s) {
    cosine = c;
    sine = s;
    turn = tangent_of_half(c, s);
  }

  REPOSE_FN void consider(const Vec<3>& other, double other_radius, std::int32_t number) {
    const double reach = own + other_radius;
    const Vec<3> apart = other - centre;
    const double apart2 = dot(apart, apart);
    if (apart2 >= (radius + reach) * (radius + reach)) return;
    const Support support{other, reach, number};
    if (on[0].is(support) || on[1].is(support)) return;
    // The distance is `reach` where a cos + b sin = c; this sum rises where the sphere comes nearer.
    const double a = dot(apart, from);
    const double b = dot(apart, ahead);
    const double c = (apart2 + radius * radius - reach * reach) / (2.0 * radius);
    const bool touches = radius * (c - a) <= touching * reach * reach;
    meet(support, -a, -b, -c, touches, touches && enters(-b / reach, -a / reach));
  }

  /// The same for a plane.
  void consider(const Support& plane) {
    if (on[0].is(plane) || on[1].is(plane)) return;
    const double a = dot(plane.centre, from);
    const double b = dot(plane.centre, ahead);
    const double c = (plane.reach - dot(plane.centre, centre)) / radius;
    const bool touches = radius * (a - c) <= touching * own;
    meet(plane, a, b, c, touches, touches && enters(b, a));
  }

  /// The lowest and highest coordinate [L] of the arc along an axis.
  std::array<double, 2> range(int axis) const {
    const double a = from[axis];
    const double b = ahead[axis];
    const double last = a * cosine + b * sine;
    const double slope = b * cosine - a * sine;  // at the end
    double low = std::min(a, last);
    double high = std::max(a, last);
    if (b > 0.0 && slope < 0.0) high = std::sqrt(a * a + b * b);
    if (b < 0.0 && slope > 0.0) low = -std::sqrt(a * a + b * b);
    return {centre[axis] + radius * low, centre[axis] + radius * high};
  }

  static double tangent_of_half(double c, double s) { return s / (1.0 + c); }

 private:
  /// Whether the arc enters a support that it touches at the start: it leads away from it with this sine, or bends
  /// towards it.
  bool enters(double away, double bent) const {
    constexpr double rounding = 1e-9;
    return away < -2.0 * tolerance || (away < 2.0 * tolerance && bent > 10.0 * rounding);
  }

  /// Meets a support where a cos + b sin sinks through c; or at the start, if it is touched and lies in the path.
  REPOSE_FN void meet(const Support& support, double a, double b, double c, bool touches, bool in_path) {
    double meet_cosine = 1.0;
    double meet_sine = 0.0;
    double meet_turn = 0.0;
    if (!in_path || left.is(support)) {
      const double length2 = a * a + b * b;
      const double across2 = length2 - c * c;
      if (!(across2 > grazing * grazing * length2)) return;
      const double across = std::sqrt(across2);
      meet_sine = (b * c + a * across) / length2;
      if (meet_sine <= (touches ? grazing : 0.0)) return;
      meet_cosine = (a * c - b * across) / length2;
      if (meet_cosine < -0.5) return;  // far beyond the end of any arc
      meet_turn = tangent_of_half(meet_cosine, meet_sine);
    }
    if (meet_turn > turn) return;
    if (meet_turn == turn && met.number != nothing && !before(support, met)) return;
    met = support;
    turn = meet_turn;
    cosine = meet_cosine;
    sine = meet_sine;
  }
};

}  // namespace repose::deposition::spheres
