// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/motions.hpp"

#include <numbers>

namespace repose {

namespace {

template <int D>
Vec<D> direction_of(const Coordinates& numbers) {
  const auto vector = vec<D>(numbers);
  return vector * (1.0 / magnitude(vector));
}

template <int D>
double length_of(const Coordinates& numbers) {
  return magnitude(vec<D>(numbers));
}

/// About which a wall turns: out of the plane in two dimensions.
template <int D>
Spin<D> axis_of(const Coordinates& axis) {
  if constexpr (D == 2) {
    return 1.0;
  } else {
    return direction_of<3>(axis);
  }
}

}  // namespace

void MovingWall::time_keys(Parameters& keys) {
  keys.number("start", starts, not_negative, "T", "the wall stands still until then");
  keys.optional_number("stop", stops, {"", "never"}, not_negative, "T", "the wall stands still from then on");
}

template <int D>
WallMotion<D> MovingWall::between_times(typename WallMotion<D>::Kind kind) const {
  WallMotion<D> motion{.kind = kind, .start = starts};
  if (stops) motion.stop = *stops;
  return motion;
}

void DrivenWall::keys(Parameters& keys, std::int64_t dimension) {
  keys.vector("velocity", velocity, dimension, std::nullopt, "L/T", "velocity of the wall");
  time_keys(keys);
}

template <int D>
WallMotion<D> DrivenWall::made() const {
  auto motion = between_times<D>(WallMotion<D>::Kind::velocity);
  motion.direction = direction_of<D>(velocity);
  motion.speed = length_of<D>(velocity);
  return motion;
}

void VibratingWall::keys(Parameters& keys, std::int64_t dimension) {
  keys.vector("amplitude", amplitude, dimension, std::nullopt, "L",
              "largest displacement from the middle of the vibration");
  keys.number("frequency", frequency, required, positive, "1/T", "cycles per time");
  keys.number("phase", phase, 0.0, any, "deg", "of the sine at the start, from where the wall stands then");
  time_keys(keys);
}

template <int D>
WallMotion<D> VibratingWall::made() const {
  auto motion = between_times<D>(WallMotion<D>::Kind::vibration);
  motion.direction = direction_of<D>(amplitude);
  motion.amplitude = length_of<D>(amplitude);
  motion.frequency = 2.0 * std::numbers::pi * frequency;
  motion.phase = phase * std::numbers::pi / 180.0;
  return motion;
}

void RotatingWall::keys(Parameters& keys, std::int64_t dimension) {
  keys.vector("centre", centre, dimension, std::nullopt, "L", "the point about which it rotates");
  if (dimension == 3) {
    keys.vector("axis", axis, 3, Coordinates{0.0, 0.0, 1.0}, "", "about which it rotates, through the centre");
  }
  keys.number("angular_velocity", angular_velocity, required, any, "1/T", "counter-clockwise, in radians");
  time_keys(keys);
}

template <int D>
WallMotion<D> RotatingWall::made() const {
  auto motion = between_times<D>(WallMotion<D>::Kind::rotation);
  motion.speed = angular_velocity;
  motion.centre = vec<D>(centre);
  motion.axis = axis_of<D>(axis);
  return motion;
}

void BeltWall::keys(Parameters& keys, std::int64_t) {
  keys.number("speed", speed, required, any, "L/T",
              "of the surface: along from - to on the left of it, to the right on a plane that faces up");
  time_keys(keys);
}

template <int D>
WallMotion<D> BeltWall::made() const {
  auto motion = between_times<D>(WallMotion<D>::Kind::belt);
  motion.speed = speed;
  motion.axis = axis_of<D>({0.0, 0.0, 1.0});
  return motion;
}

void Piston::piston_keys(Parameters& keys, std::int64_t dimension) {
  keys.number("mass", mass, required, positive, "M", "mass of the piston; gravity does not act on it");
  keys.number("drag", drag, not_negative, "M/T", "force against the motion per speed");
  if (dimension == 2) {
    keys.number("surface_speed", surface_speed, 0.0, any, "L/T",
                "its surface runs along it as that of a belt: pressure and shear on one wall");
  }
  time_keys(keys);
}

template <int D>
WallMotion<D> Piston::piston_motion(typename WallMotion<D>::Kind kind) const {
  auto motion = between_times<D>(kind);
  motion.mass = mass;
  motion.drag = drag;
  motion.surface = surface_speed;
  motion.axis = axis_of<D>({0.0, 0.0, 1.0});
  return motion;
}

void PushedPiston::keys(Parameters& keys, std::int64_t dimension) {
  keys.vector("force", force, dimension, std::nullopt, "M L/T^2", "force on the piston, which moves along it");
  piston_keys(keys, dimension);
}

template <int D>
WallMotion<D> PushedPiston::made() const {
  auto motion = piston_motion<D>(WallMotion<D>::Kind::force);
  motion.direction = direction_of<D>(force);
  motion.force = length_of<D>(force);
  return motion;
}

void SprungPiston::keys(Parameters& keys, std::int64_t dimension) {
  keys.vector("velocity", velocity, dimension, std::nullopt, "L/T", "velocity of the far end of the spring");
  keys.number("stiffness", stiffness, required, positive, "M/T^2", "stiffness of the spring");
  piston_keys(keys, dimension);
}

template <int D>
WallMotion<D> SprungPiston::made() const {
  auto motion = piston_motion<D>(WallMotion<D>::Kind::spring);
  motion.direction = direction_of<D>(velocity);
  motion.speed = length_of<D>(velocity);
  motion.stiffness = stiffness;
  return motion;
}

template WallMotion<2> DrivenWall::made() const;
template WallMotion<3> DrivenWall::made() const;
template WallMotion<2> VibratingWall::made() const;
template WallMotion<3> VibratingWall::made() const;
template WallMotion<2> RotatingWall::made() const;
template WallMotion<3> RotatingWall::made() const;
template WallMotion<2> BeltWall::made() const;
template WallMotion<3> BeltWall::made() const;
template WallMotion<2> PushedPiston::made() const;
template WallMotion<3> PushedPiston::made() const;
template WallMotion<2> SprungPiston::made() const;
template WallMotion<3> SprungPiston::made() const;

Kinds<MotionKind>& motion_kinds() {
  static Kinds<MotionKind> kinds{
      {StandingWall{}, DrivenWall{}, VibratingWall{}, RotatingWall{}, BeltWall{}, PushedPiston{}, SprungPiston{}}};
  return kinds;
}

}  // namespace repose
