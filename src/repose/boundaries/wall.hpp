// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace repose {

/// What moves a wall, along one direction. Gravity does not act on walls.
template <int D>
struct WallMotion {
  enum class Kind {
    none,
    velocity,  ///< at a given speed, whatever it meets
    force,     ///< a piston of some mass under a given force and the push of the grains
    spring     ///< the same, pulled by a spring whose far end goes at a given speed
  };
  Kind kind = Kind::none;
  Vec<D> direction{};      ///< unit vector
  double speed = 0.0;      ///< [L/T] of the wall or of the far end of the spring
  double force = 0.0;      ///< [M L/T^2]
  double stiffness = 0.0;  ///< [M/T^2] of the spring
  double mass = 0.0;       ///< [M]
  double drag = 0.0;       ///< [M/T] force against the motion per speed
  double start = 0.0;      ///< [T] before that the wall stands still

  /// Whether the push of the grains changes the motion.
  bool feels_grains() const { return kind == Kind::force || kind == Kind::spring; }
};

/// A straight wall: infinite, with the grains on the side that its normal points to, or of finite length, and then it
/// has two sides. It meets a grain at its rim and acts by the pair law, as a grain of the same size and mass would.
template <int D>
struct Wall {
  Vec<D> point{};   ///< [L] on the wall; the middle of a finite one
  Vec<D> normal{};  ///< unit vector
  /// Stands for a row of grain centres (Baxter et al. 1997): acts at the height of the centre, holds a grain at rest
  /// one diameter above it, and has no friction.
  bool smooth = false;
  double half_length = std::numeric_limits<double>::infinity();  ///< [L] of a segment; the radius of a disc in 3D
  std::uint16_t material = 0;
  WallMotion<D> motion{};
  double opens_at = std::numeric_limits<double>::infinity();  ///< [T] from then on it is not there

  bool finite() const { return half_length < std::numeric_limits<double>::infinity(); }
};

/// How far a wall has gone.
struct WallState {
  double displacement = 0.0;  ///< [L] along its direction
  double speed = 0.0;         ///< [L/T] half a step before
  double work = 0.0;          ///< [M L^2/T^2] done on the grains
  double dissipated = 0.0;    ///< [M L^2/T^2] of that, against dashpots and friction
};

/// Brings a wall from one step to the next by leapfrog: `kick` [T] is the time over which forces act, `push` the force
/// of the grains on it.
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

/// A wall at one moment, as a grain meets it.
template <int D>
struct WallNow {
  Vec<D> point{};
  Vec<D> velocity{};
  bool there = true;
};

template <int D>
WallNow<D> wall_now(const Wall<D>& wall, const WallState& state, double time) {
  return {wall.point + wall.motion.direction * state.displacement, wall.motion.direction * state.speed,
          time < wall.opens_at};
}

/// Where a grain is above a wall: the shortest way from the wall to its centre.
template <int D>
struct AboveWall {
  double height;  ///< [L]
  Vec<D> normal;  ///< from the wall to the centre
};

/// `from_point` is the way from the point of the wall to the centre.
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

}  // namespace repose
