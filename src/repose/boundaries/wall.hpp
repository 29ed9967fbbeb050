// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall_shape.hpp"
#include "repose/core/box.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/inline.hpp"
#include "repose/core/reproducible_math.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace repose {

/// How a wall moves: prescribed, or driven by forces. Gravity does not act on walls.
template <int D>
struct WallMotion {
  enum class Kind {
    none,
    velocity,   ///< a given speed along a direction
    vibration,  ///< a sine along a direction
    rotation,   ///< a given angular velocity about a centre
    belt,       ///< the wall stays; its surface runs round it, as a conveyor belt does
    force,      ///< a piston with a mass, driven by a given force and by the contact forces of the grains
    spring      ///< a piston that is also pulled by a spring, whose far end moves at a given speed
  };
  Kind kind = Kind::none;
  Vec<D> direction{};      ///< unit vector; zero for a rotation and a belt
  double speed = 0.0;      ///< [L/T] of the wall, the surface of the belt, or the far end of the spring; [1/T] angular
  double surface = 0.0;    ///< [L/T] of the surface of a piston, which runs round it as that of a belt
  double amplitude = 0.0;  ///< [L] of a vibration
  double frequency = 0.0;  ///< [1/T] angular frequency of a vibration
  double phase = 0.0;      ///< [rad] of a vibration at its start
  Vec<D> centre{};         ///< [L] of a rotation
  Spin<D> axis{};          ///< unit vector about which a rotation turns and surfaces run, counter-clockwise
  double force = 0.0;      ///< [M L/T^2]
  double stiffness = 0.0;  ///< [M/T^2] stiffness of the spring
  double mass = 0.0;       ///< [M]
  double drag = 0.0;       ///< [M/T] force per speed, against the motion
  double start = 0.0;      ///< [T] time at which the motion begins; the wall stands still before it
  double stop = std::numeric_limits<double>::infinity();  ///< [T] time at which the motion ends

  /// Whether contact forces of the grains change the motion.
  bool feels_grains() const { return kind == Kind::force || kind == Kind::spring; }
  /// Whether velocities of the wall differ from place to place.
  bool turns() const { return kind == Kind::rotation || kind == Kind::belt; }
  bool going(double time) const { return kind != Kind::none && time >= start && time < stop; }

  /// The displacement [L] of a vibration.
  double vibrated(double time) const {
    const double since = std::clamp(time, start, stop) - start;
    return amplitude * (reproducible::sin(frequency * since + phase) - reproducible::sin(phase));
  }

  /// The mean speed over the step that begins at `time` [T], of a motion that the grains do not change.
  double prescribed_speed(double time, double dt) const {
    if (kind == Kind::vibration) return (vibrated(time + dt) - vibrated(time)) / dt;
    return going(time) ? speed : 0.0;
  }
};

/// A wall: in two dimensions straight, in three a plane or one of the shapes. An infinite wall has grains only on the
/// side that its normal points to; a finite one has two sides. It touches a grain at the grain's rim, in one place, and
/// its force follows the pair law for a partner of equal size and mass, without curvature. So a grain that touches a
/// cylinder or a cone all around feels it at the nearest place alone.
template <int D>
struct Wall {
  Vec<D> point{};   ///< [L] a point on the wall; the middle of a finite wall
  Vec<D> normal{};  ///< unit vector; the axis of a frustum
  /// A smooth wall stands for a row of grain centres (Baxter et al. 1997): it acts at the height of a grain's centre,
  /// holds a grain at rest one diameter above itself, and has no friction.
  bool smooth = false;
  /// [L] Half the length in two dimensions; in three the largest distance from `point`, which is a disc's radius.
  double half_length = std::numeric_limits<double>::infinity();
  std::uint16_t material = 0;
  WallMotion<D> motion{};
  double opens_at = std::numeric_limits<double>::infinity();  ///< [T] time from which the wall is absent
  [[no_unique_address]] WallShape<D> shape{};

  bool finite() const { return half_length < std::numeric_limits<double>::infinity(); }
};

/// The motion of a wall so far.
struct WallState {
  double displacement = 0.0;  ///< [L] along the wall's direction; [rad] of a rotation; [L] of the surface of a belt
  double speed = 0.0;         ///< [L/T] or [1/T], half a step before the position
  double work = 0.0;          ///< [M L^2/T^2] work done on the grains
  double dissipated = 0.0;    ///< [M L^2/T^2] the part of it that dashpots and friction dissipated
};

/// Sets the speed of a wall for the leapfrog step that begins at `time`. `kick` [T] is the time over which forces act;
/// `push` [M L/T^2] is the force of the grains on the wall.
template <int D>
void kick_wall(const WallMotion<D>& motion, WallState& state, double time, double kick, double dt, const Vec<D>& push) {
  if (!motion.feels_grains()) {
    state.speed = motion.prescribed_speed(time, dt);
  } else if (motion.going(time)) {
    double force = motion.force + dot(push, motion.direction) - motion.drag * state.speed;
    force += motion.stiffness * (motion.speed * (time - motion.start) - state.displacement);
    state.speed += kick * force / motion.mass;
  } else {
    state.speed = 0.0;
  }
}

/// A vector turned by an angle [rad] about an axis.
inline Vec<2> rotated(const Vec<2>& a, double axis, double angle) {
  const double sine = reproducible::sin(axis * angle);
  const double cosine = reproducible::cos(angle);
  return {{a[0] * cosine - a[1] * sine, a[1] * cosine + a[0] * sine}};
}
inline Vec<3> rotated(const Vec<3>& a, const Vec<3>& axis, double angle) {
  const double sine = reproducible::sin(angle);
  const double cosine = reproducible::cos(angle);
  return a * cosine + cross(axis, a) * sine + axis * (dot(axis, a) * (1.0 - cosine));
}

/// The position and velocity of a wall at one time.
template <int D>
struct WallNow {
  Vec<D> point{};             ///< [L]
  Vec<D> normal{};            ///< unit vector
  Vec<D> velocity{};          ///< [L/T] of a wall that does not turn
  bool present = true;        ///< false once the wall has opened
  double inverse_mass = 0.0;  ///< [1/M] along its direction of motion; 0 where contacts do not change the motion
  Spin<D> spin{};             ///< [1/T] angular velocity of a rotation
  Vec<D> arm{};               ///< [L] from the centre of the rotation to the point
  Spin<D> belt{};             ///< [L/T] axis of a belt times its speed
  Vec<D> side{};              ///< unit vector along the wall that turns with it; in three dimensions alone

  bool turns() const { return spin != Spin<D>{} || belt != Spin<D>{}; }
  /// The velocity [L/T] of the surface where it touches, beyond `velocity`. `nearest` [L] is the place relative to the
  /// point of the wall, `facing` the unit vector from it to the grain.
  Vec<D> surface_velocity(const Vec<D>& nearest, const Vec<D>& facing) const {
    const Vec<D> from_centre = arm + nearest;
    return in_space(spin_cross(spin, from_centre), from_centre) + in_space(spin_cross(belt, facing), facing);
  }
};

/// Whether a wall only turns about the axis of its own shape: it then moves nowhere, and only its surface has a speed.
template <int D>
bool turns_in_itself(const Wall<D>& wall) {
  if constexpr (D == 3) {
    using Kind = WallShape<3>::Kind;
    constexpr double rounding = 1e-12;
    const auto& motion = wall.motion;
    if (motion.kind != WallMotion<3>::Kind::rotation) return false;
    if (wall.shape.kind != Kind::disc && wall.shape.kind != Kind::frustum) return false;
    if (magnitude(cross(motion.axis, wall.normal)) > rounding) return false;
    const Vec<3> arm = wall.point - motion.centre;
    return magnitude(tangential(arm, wall.normal)) <= rounding * (magnitude(arm) + wall.half_length);
  }
  return false;
}

template <int D>
WallNow<D> wall_now(const Wall<D>& wall, const WallState& state, double time) {
  const auto& motion = wall.motion;
  WallNow<D> now;
  now.point = wall.point + motion.direction * state.displacement;
  now.normal = wall.normal;
  now.velocity = motion.direction * state.speed;
  now.present = time < wall.opens_at;
  now.inverse_mass = motion.feels_grains() && motion.going(time) ? 1.0 / motion.mass : 0.0;
  if constexpr (D == 3) now.side = wall.shape.side == Vec<3>{} ? any_perpendicular(wall.normal) : wall.shape.side;
  if (turns_in_itself(wall)) {
    now.spin = motion.axis * state.speed;
    now.arm = wall.point - motion.centre;
  } else if (motion.kind == WallMotion<D>::Kind::rotation) {
    now.spin = motion.axis * state.speed;
    now.arm = rotated(Vec<D>(wall.point - motion.centre), motion.axis, state.displacement);
    now.point = motion.centre + now.arm;
    now.normal = rotated(wall.normal, motion.axis, state.displacement);
    if constexpr (D == 3) now.side = rotated(now.side, motion.axis, state.displacement);
  } else if (motion.kind == WallMotion<D>::Kind::belt) {
    now.belt = motion.axis * -state.speed;
  } else if (motion.surface != 0.0 && motion.going(time)) {
    now.belt = motion.axis * -motion.surface;
  }
  return now;
}

/// The largest displacement [L] of any point of a wall whose state changes by `change` [L] or [rad].
template <int D>
double farthest_moved(const Wall<D>& wall, double change) {
  if (wall.motion.kind == WallMotion<D>::Kind::belt) return 0.0;
  if (wall.motion.kind != WallMotion<D>::Kind::rotation) return std::fabs(change);
  if (turns_in_itself(wall)) return 0.0;
  Vec<D> arm = wall.point - wall.motion.centre;
  if constexpr (D == 3) arm = tangential(arm, wall.motion.axis);
  return std::fabs(change) * (magnitude(arm) + wall.half_length);
}

/// The shortest line from a wall to the centre of a grain.
template <int D>
struct AboveWall {
  double height;  ///< [L] its length; negative behind an infinite wall
  Vec<D> normal;  ///< unit vector from the wall to the centre
};

/// The shortest line to a centre that lies at `from_point` [L] relative to the wall's point, for a wall whose normal is
/// `normal` now. In three dimensions it must be a plane or a disc.
template <int D>
REPOSE_FN AboveWall<D> above(const Wall<D>& wall, const Vec<D>& normal, const Vec<D>& from_point) {
  if constexpr (D == 3) REPOSE_ASSERT(wall.shape.kind == WallShape<3>::Kind::disc);
  const double height = dot(from_point, normal);
  if (!wall.finite()) return {height, normal};
  const Vec<D> along = from_point - normal * height;
  const double reach = magnitude(along);
  if (reach <= wall.half_length) return height < 0.0 ? AboveWall<D>{-height, -normal} : AboveWall<D>{height, normal};
  const Vec<D> from_end = from_point - along * (wall.half_length / reach);
  const double distance = magnitude(from_end);
  return {distance, from_end * (1.0 / std::max(distance, std::numeric_limits<double>::min()))};
}

/// The same for a wall of any shape as it stands now.
template <int D>
REPOSE_FN AboveWall<D> above(const Wall<D>& wall, const WallNow<D>& now, const Vec<D>& from_point) {
  if constexpr (D == 3) {
    if (wall.shape.kind != WallShape<3>::Kind::disc) {
      const auto nearest = nearest_on(wall.shape, now.normal, now.side, from_point);
      return {nearest.height, nearest.normal};
    }
  }
  return above(wall, now.normal, from_point);
}

/// Whether the nearest point of a wall, to a centre at `from_point` [L] relative to the wall's point, is on its end:
/// its edge, a corner or a rim.
template <int D>
REPOSE_FN bool beyond_end(const Wall<D>& wall, const WallNow<D>& now, const Vec<D>& from_point) {
  if (!wall.finite()) return false;
  if constexpr (D == 3) {
    if (wall.shape.kind != WallShape<3>::Kind::disc) {
      return nearest_on(wall.shape, now.normal, now.side, from_point).at_end;
    }
  }
  return magnitude(from_point - now.normal * dot(from_point, now.normal)) > wall.half_length;
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
