// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/numbers.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/methods/deposition/settings.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

/// The critical-angle rule of Bratberg's paper one (section II A), for discs of any size.
///
/// A disc falls vertically until it touches another. It sticks if the angle of the contact from the vertical is less
/// than the critical angle. Otherwise it rolls down around the disc that it touches, until it touches a second one.
/// There it sticks by the same rule, or lies between the two (if the second is on the far side), or rolls on around the
/// second. Below the equator it falls again. The geometry is exact, with circles and without angles: directions are
/// compared by cross products.
namespace repose::deposition {

/// A support: the number of a disc, or one of these.
inline constexpr std::int32_t nothing = -1;
inline constexpr std::int32_t on_floor = -2;
inline constexpr std::int32_t on_left_wall = -3;
inline constexpr std::int32_t on_right_wall = -4;

/// A disc in the packing, or an image of it.
struct Fixed {
  double x = 0.0;  ///< [L]
  double y = 0.0;
  double radius = 0.0;
  std::int32_t number = nothing;
};

/// The final position of a disc and its supports.
struct Rest {
  double x = 0.0;  ///< [L] not wrapped into a periodic box
  double y = 0.0;
  std::int32_t first = nothing;   ///< the support that it rolled around or stuck to
  std::int32_t second = nothing;  ///< the support that stopped it, if that is another
};

constexpr double small_angle = 1e-9;   // [rad] a touch behind the disc by less than this counts as a touch here
constexpr double grazing = 1e-12;      // [reach] a falling disc passes one that it would only graze
constexpr double grazing_arc = 1e-14;  // [reach^2] the same for rolling: square of the half-width of the arc

/// The first touch of a falling disc.
struct Landing {
  Fixed on;
  double y = -std::numeric_limits<double>::infinity();
};

/// A pack of two numbers.
using Two = double __attribute__((vector_size(16)));
REPOSE_FN double root(double number) { return std::sqrt(number); }
REPOSE_FN Two root(Two numbers) { return Two{std::sqrt(numbers[0]), std::sqrt(numbers[1])}; }

/// A falling disc and its highest landing so far, not above the start.
struct Fall {
  double x;
  double radius;
  double start;     ///< [L] y at which the fall starts
  Fixed leave_out;  ///< the disc beside which it falls, and which it does not meet; not a number: none
  Landing best{};

  /// The height of the centre where it lands on a disc, minus infinity if it passes. T is a number or a pack of them.
  /// It has no branches, because the processor cannot predict which discs are passed.
  template <class T>
  REPOSE_FN T landing(T disc_x, T disc_y, T disc_radius) const {
    const T reach = radius + disc_radius;
    const T dx = x - disc_x;
    const T y = disc_y + root((reach - dx) * (reach + dx));
    const T aside = dx < 0.0 ? -dx : dx;
    const auto meets = (reach - aside > grazing * reach) & (y <= start + small_angle * reach) &
                       ((disc_x != leave_out.x) | (disc_y != leave_out.y));
    return meets ? y : T{} - std::numeric_limits<double>::infinity();
  }
  REPOSE_FN void consider(const Fixed& disc) { land_on(disc, landing(disc.x, disc.y, disc.radius)); }
  REPOSE_FN void land_on(const Fixed& disc, double y) {
    if (y > best.y || (y == best.y && before(disc, best.on))) best = {disc, y};
  }
  static bool before(const Fixed& a, const Fixed& b) {
    return a.number < b.number || (a.number == b.number && a.x < b.x);
  }
};

/// The arc of a disc that rolls around `pivot` to the side +1 (right) or -1 (left), and the first touch on it. Offsets
/// from the pivot are (u, y), with u positive towards that side.
struct Arc {
  Fixed pivot;
  double radius;
  double side;
  double u0;  ///< offset at the start
  double y0;
  double reach = pivot.radius + radius;
  Fixed met{};
  double u = 0.0;  ///< offset at the first touch
  double y = 0.0;

  /// The sine of the angle by which (u_a, y_a) is ahead of (u_b, y_b), clockwise, times the squared reach.
  static double ahead(double u_a, double y_a, double u_b, double y_b) { return u_a * y_b - y_a * u_b; }

  REPOSE_FN void consider(const Fixed& disc) {
    const double ex = side * (disc.x - pivot.x);
    const double ey = disc.y - pivot.y;
    const double e2 = ex * ex + ey * ey;
    const double other = radius + disc.radius;
    if (e2 >= (reach + other) * (reach + other)) return;
    // A disc behind is met from the back only, unless it is so large that it extends around the pivot.
    if (ex <= 0.0 && other * other <= reach * reach + e2) return;
    if (disc.number == pivot.number && disc.x == pivot.x) return;
    // The two positions with the centre at `reach` from the pivot and `other` from the disc; this is the one met first.
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

/// Drops discs onto those that a `Search` knows. A search has the functions `fall(Fall&)` and `roll(Arc&)`, which call
/// `consider` for every disc and image that could be met. Its `prefetch(x)` says where a disc will soon fall.
template <class Search>
class Roller {
 public:
  Roller(const DepositionSettings& settings, const Search& search)
      : settings_(settings),
        search_(search),
        least_upright_(settings.critical_angle_deg >= 90.0
                           ? 0.0
                           : reproducible::cos(settings.critical_angle_deg * std::numbers::pi / 180.0)) {}

  /// The final position of a disc dropped at x; none if it falls without end or does not come to rest.
  REPOSE_FN std::optional<Rest> drop(double x, double radius) const {
    Rest rest{x};
    Fixed pivot{no_number, no_number};
    double start = std::numeric_limits<double>::infinity();
    double side = 1.0;
    bool falls = true;
    constexpr int most_turns = 1'000'000;
    for (int turn = 0; turn < most_turns; ++turn) {
      if (falls) {
        const auto landing = land({rest.x, radius, start, pivot});
        if (!std::isfinite(landing.y)) return std::nullopt;
        rest.y = landing.y;
        pivot = landing.on;
      }
      rest.first = pivot.number;
      if (pivot.number == on_floor) return rest;
      const double dx = rest.x - pivot.x;
      const double dy = rest.y - pivot.y;
      if (dy > least_upright_ * (radius + pivot.radius)) return rest;  // sticks
      rest.second = nothing;
      if (dx != 0.0) side = dx > 0.0 ? 1.0 : -1.0;
      Arc arc{pivot, radius, side, side * dx, dy};
      roll(arc);
      falls = arc.met.number == nothing;
      if (falls) {
        rest.x = pivot.x + side * arc.reach;
        start = pivot.y;
        continue;
      }
      rest.x = pivot.x + side * arc.u;
      rest.y = pivot.y + arc.y;
      rest.second = arc.met.number;
      const bool between = arc.met.number < nothing || side * (arc.met.x - rest.x) > 0.0;
      if (between) return rest;
      std::swap(rest.first, rest.second);  // it touches both, and rolls on around the second
      pivot = arc.met;
    }
    return std::nullopt;
  }

 private:
  REPOSE_FN Landing land(Fall fall) const {
    search_.fall(fall);
    if (const double lowest = settings_.floor + fall.radius; lowest > fall.best.y)
      return {{.number = on_floor}, lowest};
    return fall.best;
  }

  REPOSE_FN void roll(Arc& arc) const {
    search_.roll(arc);
    const auto height = [&](double along) { return std::sqrt((arc.reach - along) * (arc.reach + along)); };
    if (const double low = settings_.floor + arc.radius - arc.pivot.y; low >= 0.0 && low < arc.reach) {
      arc.meet({.number = on_floor}, height(low), low);
    }
    if (settings_.box.periodic) return;
    const bool right = arc.side > 0.0;
    const double wall = right ? settings_.box.x_max : settings_.box.x_min;
    const double to_wall = arc.side * (wall - arc.pivot.x) - arc.radius;
    if (to_wall < arc.reach) arc.meet({.number = right ? on_right_wall : on_left_wall}, to_wall, height(to_wall));
  }

  const DepositionSettings& settings_;
  const Search& search_;
  double least_upright_;  // cosine of the critical angle
};

}  // namespace repose::deposition
