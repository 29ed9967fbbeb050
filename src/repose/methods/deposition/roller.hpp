// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/methods/deposition/settings.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

/// Where a dropped disc comes to rest: the critical-angle rule of Bratberg's paper one (section II A), for any sizes.
///
/// The disc falls upright to its first touch. It sticks where the contact is less than the critical angle off upright;
/// else it rolls down around the disc that it touches, to the next touch: there it sticks by the same rule, or lies
/// between the two (the new one on the far side), or rolls on around the new one. Past the equator it falls again.
/// Everything is exact circle geometry, without angles: comparisons of directions are cross products.
namespace repose::deposition {

/// What a disc rests on: the number of a disc, or one of these.
inline constexpr std::int32_t nothing = -1;
inline constexpr std::int32_t on_floor = -2;
inline constexpr std::int32_t on_left_wall = -3;
inline constexpr std::int32_t on_right_wall = -4;

/// A disc in the packing, or an image of it.
struct Fixed {
  std::int32_t number = nothing;
  double x = 0.0;  ///< [L]
  double y = 0.0;
  double radius = 0.0;
};

/// Where a disc ends: its place and what it touches there.
struct Rest {
  double x = 0.0;  ///< [L] as it came, perhaps outside a periodic box
  double y = 0.0;
  std::int32_t first = nothing;   ///< what it rolled around or stuck to
  std::int32_t second = nothing;  ///< what stopped it, if something else did
};

constexpr double small_angle = 1e-9;   // [rad] a touch this far behind where the disc is counts as here
constexpr double grazing = 1e-12;      // of the reach: a fall that only grazes passes by
constexpr double grazing_arc = 1e-14;  // square of the half-width of an arc that only grazes, likewise

/// First touch of a falling disc.
struct Landing {
  Fixed on;
  double y = -std::numeric_limits<double>::infinity();
};

/// The falling disc and what it has met so far; the highest landing not above where it starts counts.
struct Fall {
  double x;
  double radius;
  double start;       ///< [L] y from which it falls
  Fixed leave_out{};  ///< the disc beside which it falls
  Landing best{};

  REPOSE_FN void consider(const Fixed& disc) {
    const double reach = radius + disc.radius;
    const double dx = x - disc.x;
    if (!(reach - std::fabs(dx) > grazing * reach)) return;
    if (disc.number == leave_out.number && disc.x == leave_out.x) return;
    const double y = disc.y + std::sqrt((reach - dx) * (reach + dx));
    if (y > start + small_angle * reach) return;
    if (y > best.y || (y == best.y && before(disc, best.on))) best = {disc, y};
  }
  static bool before(const Fixed& a, const Fixed& b) {
    return a.number < b.number || (a.number == b.number && a.x < b.x);
  }
};

/// The arc of a disc that rolls around `pivot`, to the side +1 (right) or -1, and the first touch on it. Offsets from
/// the pivot are (u, y) with u along the side.
struct Arc {
  Fixed pivot;
  double radius;
  double side;
  double u0;  ///< where it starts
  double y0;
  double reach = pivot.radius + radius;
  Fixed met{};
  double u = 0.0;  ///< where it meets that
  double y = 0.0;

  /// Clockwise advance of (u_a, y_a) over (u_b, y_b), times the squared reach.
  static double ahead(double u_a, double y_a, double u_b, double y_b) { return u_a * y_b - y_a * u_b; }

  REPOSE_FN void consider(const Fixed& disc) {
    const double ex = side * (disc.x - pivot.x);
    const double ey = disc.y - pivot.y;
    const double e2 = ex * ex + ey * ey;
    const double other = radius + disc.radius;
    if (e2 >= (reach + other) * (reach + other)) return;
    // What lies behind is met from the back only, unless it is so large that it reaches around the pivot.
    if (ex <= 0.0 && other * other <= reach * reach + e2) return;
    if (disc.number == pivot.number && disc.x == pivot.x) return;
    // Where the centre is `reach` from the pivot and `other` from the disc; of the two the one met first.
    const double along = 0.5 * (1.0 + (reach * reach - other * other) / e2);
    const double across2 = reach * reach / e2 - along * along;
    if (!(across2 * e2 > grazing_arc * reach * reach)) return;
    const double across = std::sqrt(across2);
    meet(disc, along * ex - across * ey, along * ey + across * ex);
  }

  REPOSE_FN void meet(const Fixed& disc, double meet_u, double meet_y) {
    if (meet_y < 0.0 || ahead(meet_u, meet_y, u0, y0) < -small_angle * reach * reach) return;
    const double later = met.number == nothing ? -1.0 : ahead(meet_u, meet_y, u, y);
    if (later > 0.0 || (later == 0.0 && !Fall::before(disc, met))) return;
    met = disc;
    u = meet_u;
    y = meet_y;
  }
};

/// Drops discs onto those that `Search` knows. A search has `fall(Fall&)` and `roll(Arc&)`, which show to `consider`
/// every disc, and image, that could be met.
template <class Search>
class Roller {
 public:
  Roller(const DepositionSettings& settings, const Search& search)
      : settings_(settings),
        search_(search),
        least_upright_(settings.critical_angle_deg >= 90.0
                           ? 0.0
                           : reproducible::cos(settings.critical_angle_deg * std::numbers::pi / 180.0)) {}

  /// None if the disc falls for ever, or does not come to rest.
  std::optional<Rest> drop(double x, double radius) const {
    Fall fall{x, radius, std::numeric_limits<double>::infinity()};
    if (!land(fall)) return std::nullopt;
    Rest rest{x, fall.best.y};
    Fixed pivot = fall.best.on;
    double side = 1.0;
    constexpr int most_turns = 1'000'000;
    for (int turn = 0; turn < most_turns; ++turn) {
      rest.first = pivot.number;
      if (pivot.number == on_floor) return rest;
      const double dx = rest.x - pivot.x;
      const double dy = rest.y - pivot.y;
      if (dy > least_upright_ * (radius + pivot.radius)) return rest;  // sticks
      rest.second = nothing;
      if (dx != 0.0) side = dx > 0.0 ? 1.0 : -1.0;
      Arc arc{pivot, radius, side, side * dx, dy};
      roll(arc);
      if (arc.met.number != nothing) {
        rest.x = pivot.x + side * arc.u;
        rest.y = pivot.y + arc.y;
        rest.second = arc.met.number;
        const bool between = arc.met.number < nothing || side * (arc.met.x - rest.x) > 0.0;
        if (between) return rest;
        std::swap(rest.first, rest.second);  // it touches both, and goes on around the new one
        pivot = arc.met;
        continue;
      }
      rest.x = pivot.x + side * arc.reach;
      Fall again{rest.x, radius, pivot.y, pivot};
      if (!land(again)) return std::nullopt;
      rest.y = again.best.y;
      pivot = again.best.on;
    }
    return std::nullopt;
  }

 private:
  bool land(Fall& fall) const {
    search_.fall(fall);
    if (const double lowest = settings_.floor + fall.radius; lowest > fall.best.y) fall.best = {{on_floor}, lowest};
    return std::isfinite(fall.best.y);
  }

  void roll(Arc& arc) const {
    search_.roll(arc);
    const auto height = [&](double along) { return std::sqrt((arc.reach - along) * (arc.reach + along)); };
    if (const double low = settings_.floor + arc.radius - arc.pivot.y; low >= 0.0 && low < arc.reach) {
      arc.meet({on_floor}, height(low), low);
    }
    if (settings_.box.periodic) return;
    const bool right = arc.side > 0.0;
    const double wall = right ? settings_.box.x_max : settings_.box.x_min;
    const double room = arc.side * (wall - arc.pivot.x) - arc.radius;
    if (room < arc.reach) arc.meet({right ? on_right_wall : on_left_wall}, room, height(room));
  }

  const DepositionSettings& settings_;
  const Search& search_;
  double least_upright_;  // cosine of the critical angle
};

}  // namespace repose::deposition
