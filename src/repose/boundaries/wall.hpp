// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/inline.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace repose {

/// The prescribed or forced motion of a wall along one direction. Gravity does not act on walls.
template <int D>
struct WallMotion {
  enum class Kind {
    none,
    velocity,  ///< a given speed, unaffected by the grains
    force,     ///< a piston with a mass, driven by a given force and by the contact forces of the grains
    spring     ///< a piston that is also pulled by a spring, whose far end moves at a given speed
  };
  Kind kind = Kind::none;
  Vec<D> direction{};      ///< unit vector
  double speed = 0.0;      ///< [L/T] speed of the wall, or of the far end of the spring
  double force = 0.0;      ///< [M L/T^2]
  double stiffness = 0.0;  ///< [M/T^2] stiffness of the spring
  double mass = 0.0;       ///< [M]
  double drag = 0.0;       ///< [M/T] force per speed, against the motion
  double start = 0.0;      ///< [T] time at which the motion begins; the wall stands still before it

  /// Whether contact forces of the grains change the motion.
  bool feels_grains() const { return kind == Kind::force || kind == Kind::spring; }
};

/// A straight wall. An infinite wall has grains only on the side that its normal points to; a wall of finite length has
/// two sides. It touches a grain at the grain's rim, and its force follows the pair law for a partner of equal size and
/// mass.
template <int D>
struct Wall {
  Vec<D> point{};   ///< [L] a point on the wall; the middle of a finite wall
  Vec<D> normal{};  ///< unit vector
  /// A smooth wall stands for a row of grain centres (Baxter et al. 1997): it acts at the height of a grain's centre,
  /// holds a grain at rest one diameter above itself, and has no friction.
  bool smooth = false;
  double half_length = std::numeric_limits<double>::infinity();  ///< [L] half the length in 2D; the radius in 3D
  std::uint16_t material = 0;
  WallMotion<D> motion{};
  double opens_at = std::numeric_limits<double>::infinity();  ///< [T] time from which the wall is absent

  bool finite() const { return half_length < std::numeric_limits<double>::infinity(); }
};

/// The motion of a wall so far.
struct WallState {
  double displacement = 0.0;  ///< [L] along the wall's direction
  double speed = 0.0;         ///< [L/T] speed half a step before the position
  double work = 0.0;          ///< [M L^2/T^2] work done on the grains
  double dissipated = 0.0;    ///< [M L^2/T^2] the part of it that dashpots and friction dissipated
};

/// Advances a wall by one leapfrog step. `kick` [T] is the time over which forces act; `push` [M L/T^2] is the force of
/// the grains on the wall.
template <int D>
void move_wall(const WallMotion<D>& motion, WallState& state, double time, double kick, double dt, const Vec<D>& push) {
  if (motion.kind == WallMotion<D>::Kind::none || time < motion.start) return;
  if (motion.feels_grains()) {
    double force = motion.force + dot(push, motion.direction) - motion.drag * state.speed;
    force += motion.stiffness * (motion.speed * (time - motion.start) - state.displacement);
    state.speed += kick * force / motion.mass;
  } else {
    state.speed = motion.speed;
  }
  state.displacement += state.speed * dt;
}

/// The position and velocity of a wall at one time.
template <int D>
struct WallNow {
  Vec<D> point{};             ///< [L]
  Vec<D> velocity{};          ///< [L/T]
  bool present = true;        ///< false once the wall has opened
  double inverse_mass = 0.0;  ///< [1/M] along its direction of motion; 0 where contacts do not change the motion
};

template <int D>
WallNow<D> wall_now(const Wall<D>& wall, const WallState& state, double time) {
  const bool yields = wall.motion.feels_grains() && time >= wall.motion.start;
  return {wall.point + wall.motion.direction * state.displacement, wall.motion.direction * state.speed,
          time < wall.opens_at, yields ? 1.0 / wall.motion.mass : 0.0};
}

/// The shortest line from a wall to the centre of a grain.
template <int D>
struct AboveWall {
  double height;  ///< [L] its length; negative behind an infinite wall
  Vec<D> normal;  ///< unit vector from the wall to the centre
};

/// The shortest line to a centre that lies at `from_point` [L] relative to the wall's point.
template <int D>
REPOSE_FN AboveWall<D> above(const Wall<D>& wall, const Vec<D>& from_point) {
  const double height = dot(from_point, wall.normal);
  if (!wall.finite()) return {height, wall.normal};
  const Vec<D> along = from_point - wall.normal * height;
  const double reach = magnitude(along);
  if (reach <= wall.half_length)
    return height < 0.0 ? AboveWall<D>{-height, -wall.normal} : AboveWall<D>{height, wall.normal};
  const Vec<D> from_end = from_point - along * (wall.half_length / reach);
  const double distance = magnitude(from_end);
  return {distance, from_end * (1.0 / std::max(distance, std::numeric_limits<double>::min()))};
}

/// Whether the nearest point of a wall, to a centre at `from_point` [L] relative to the wall's point, is its end.
template <int D>
REPOSE_FN bool beyond_end(const Wall<D>& wall, const Vec<D>& from_point) {
  if (!wall.finite()) return false;
  return magnitude(from_point - wall.normal * dot(from_point, wall.normal)) > wall.half_length;
}

/// How deep [L] a wall presses into a grain; negative: the gap between them.
template <int D>
REPOSE_FN double wall_overlap(const Wall<D>& wall, const AboveWall<D>& place, double radius) {
  return (wall.smooth ? 2.0 : 1.0) * radius - place.height;
}

/// The position [L] of a centre relative to the point of a wall.
template <int D>
REPOSE_FN Vec<D> from_wall(const Wall<D>& wall, const WallNow<D>& now, const Vec<D>& centre, const Box<D>& box) {
  return wall.finite() ? separation(centre, now.point, box) : Vec<D>(centre - now.point);
}

}  // namespace repose
