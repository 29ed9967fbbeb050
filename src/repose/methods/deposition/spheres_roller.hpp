// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/numbers.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/methods/deposition/spheres.hpp"
#include "repose/methods/deposition/spheres_motion.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

/// The critical-angle rule for spheres of any size.
///
/// A sphere falls vertically until it touches a support. From any place it moves down the steepest way that enters none
/// of the supports that it touches, and sticks where that way slopes by less than the critical angle. On one support
/// this slope is the angle of the contact from upright, the rule of paper one for discs. On two it is the inclination
/// of the circle about the line of their centres at the sphere; where that line is level, this is the angle from the
/// top of the circle. On three that carry it there is no way down, and it rests at any critical angle: the vertical
/// through its centre passes through the triangle of the supports' centres. Every path is a vertical line or an arc of
/// a circle, so the geometry is exact. Sources: Visscher & Bolsterli (1972); Jodrey & Tory (1979); Bratberg (2003),
/// paper one, section II A.
namespace repose::deposition::spheres {

/// The end of a drop.
struct Rest {
  enum class Kind {
    rest,
    lost,       ///< it falls without end
    unresolved  ///< it does not come to rest
  };
  Kind kind = Kind::unresolved;
  Vec<3> position{};  ///< [L] not wrapped into a periodic box
  std::array<std::int32_t, 3> supports{nothing, nothing, nothing};
};

/// Drops spheres onto those that a `Search` knows. A search has the functions `fall(Fall&)` and `roll(Arc&)`, which
/// call `consider` for every sphere and image that could be met.
template <class Search>
class Roller {
 public:
  Roller(const SphereDepositionSettings& settings, const Search& search)
      : settings_(settings),
        search_(search),
        sticks_below_(settings.critical_angle_deg >= 90.0 ? 1.0
                                                          : reproducible::sin(radians(settings.critical_angle_deg))) {
    const auto& box = settings.box;
    const auto wall = [&](int number, int axis, double side, double at) {
      if (!std::isfinite(at)) return;
      Support plane{.number = on_wall(number)};
      plane.centre[axis] = side;
      plane.reach = side * at;
      walls_[walls_count_++] = plane;
    };
    if (!box.periodic) {
      wall(0, 0, 1.0, box.x_min);
      wall(1, 0, -1.0, box.x_max);
    }
    if (!box.periodic_y) {
      wall(2, 1, 1.0, box.y_min);
      wall(3, 1, -1.0, box.y_max);
    }
  }

  /// The final position of a sphere dropped at (x, y).
  Rest drop(double x, double y, double radius) const {
    constexpr int most_turns = 1'000'000;
    constexpr int most_idle = 1000;  // turns in one place
    const Support floor{{{0.0, 0.0, 1.0}}, settings_.floor + radius, on_floor};
    Vec<3> place{{x, y, std::numeric_limits<double>::infinity()}};
    Touched touched;
    Support left{};
    int idle = 0;
    for (int turn = 0; turn < most_turns && idle < most_idle; ++turn) {
      // Supports that touch in one place with rounded normals may disagree about the way down; few turns settle it.
      const double tolerance = idle < 50 ? steep : 1e3 * steep;
      const auto motion = steepest_descent(touched, place, tolerance);
      if (motion.slope < sticks_below_) return at_rest(place, touched);
      const Vec<3> before = place;
      Touched next;
      if (motion.supports == 0) {
        Fall fall{place[0], place[1], radius, place[2]};
        search_.fall(fall);
        if (floor.reach > fall.height) {
          fall.on = floor;
          fall.height = floor.reach;
        }
        if (!std::isfinite(fall.height)) return {.kind = Rest::Kind::lost};
        place[2] = fall.height;
        next.add(fall.on);
        left = {};
      } else {
        const Support* leaves = nullptr;
        auto arc = path(touched, motion, place, radius, tolerance, leaves);
        arc.left = left;
        search_.roll(arc);
        consider_planes(arc, floor, radius);
        if (arc.turn > 0.0) place = arc.place();
        const bool ends = arc.met.number == nothing;
        left = ends && leaves != nullptr ? *leaves : Support{};
        for (const auto& on : arc.on) {
          if (on.number != nothing && !(ends && left.is(on))) next.add(on);
        }
        if (!ends) next.add(arc.met);
      }
      for (int k = 0; k < touched.count; ++k) {
        const auto& support = touched[k];
        if (!(left.number != nothing && left.is(support)) && support.gap(place) <= touching * size(support, radius)) {
          next.add(support);
        }
      }
      touched = next;
      if (touches_floor(touched)) return at_rest(place, touched);
      idle = magnitude(place - before) > touching * radius ? 0 : idle + 1;
    }
    return {};
  }

 private:
  static double size(const Support& support, double radius) { return support.flat() ? radius : support.reach; }
  static bool touches_floor(const Touched& touched) {
    for (int k = 0; k < touched.count; ++k) {
      if (touched[k].number == on_floor) return true;
    }
    return false;
  }
  static Rest at_rest(const Vec<3>& place, const Touched& touched) {
    return {Rest::Kind::rest, place, chosen_supports(touched, place)};
  }

  Arc path(const Touched& touched, const Motion& motion, const Vec<3>& place, double radius, double tolerance,
           const Support*& leaves) const {
    const auto* first = &touched[motion.on[0]];
    if (motion.supports == 1) return arc_on_one(*first, place, motion.direction, radius, tolerance);
    const auto* second = &touched[motion.on[1]];
    if (first->flat()) std::swap(first, second);
    return arc_on_two(*first, *second, place, motion.direction, radius, tolerance, leaves);
  }

  void consider_planes(Arc& arc, const Support& floor, double radius) const {
    if (std::isfinite(floor.reach)) arc.consider(floor);
    for (std::size_t k = 0; k < walls_count_; ++k) {
      Support wall = walls_[k];
      wall.reach += radius;
      arc.consider(wall);
    }
  }

  const SphereDepositionSettings& settings_;
  const Search& search_;
  double sticks_below_;  // sine of the critical angle
  std::array<Support, 4> walls_{};
  std::size_t walls_count_ = 0;
};

}  // namespace repose::deposition::spheres
