// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/motions.hpp"

#include <numbers>

namespace repose {

namespace {

using Motion = WallMotion<2>;

Vec<2> as_vector(const std::array<double, 2>& numbers) { return {{numbers[0], numbers[1]}}; }

Vec<2> direction_of(const std::array<double, 2>& numbers) {
  const auto vector = as_vector(numbers);
  return vector * (1.0 / magnitude(vector));
}

}  // namespace

void MovingWall::time_keys(Parameters& keys) {
  keys.number("start", starts, not_negative, "T", "the wall stands still until then");
  keys.optional_number("stop", stops, {"", "never"}, not_negative, "T", "the wall stands still from then on");
}

Motion MovingWall::between_times(Motion::Kind kind) const {
  Motion motion{.kind = kind, .start = starts};
  if (stops) motion.stop = *stops;
  return motion;
}

void DrivenWall::keys(Parameters& keys) {
  keys.vector("velocity", velocity, std::nullopt, "L/T", "velocity of the wall");
  time_keys(keys);
}

Motion DrivenWall::motion() const {
  auto motion = between_times(Motion::Kind::velocity);
  motion.direction = direction_of(velocity);
  motion.speed = magnitude(as_vector(velocity));
  return motion;
}

void VibratingWall::keys(Parameters& keys) {
  keys.vector("amplitude", amplitude, std::nullopt, "L", "largest displacement from the middle of the vibration");
  keys.number("frequency", frequency, required, positive, "1/T", "cycles per time");
  keys.number("phase", phase, 0.0, any, "deg", "of the sine at the start, from where the wall stands then");
  time_keys(keys);
}

Motion VibratingWall::motion() const {
  auto motion = between_times(Motion::Kind::vibration);
  motion.direction = direction_of(amplitude);
  motion.amplitude = magnitude(as_vector(amplitude));
  motion.frequency = 2.0 * std::numbers::pi * frequency;
  motion.phase = phase * std::numbers::pi / 180.0;
  return motion;
}

void RotatingWall::keys(Parameters& keys) {
  keys.vector("centre", centre, std::nullopt, "L", "the point about which it rotates");
  keys.number("angular_velocity", angular_velocity, required, any, "1/T", "counter-clockwise, in radians");
  time_keys(keys);
}

Motion RotatingWall::motion() const {
  auto motion = between_times(Motion::Kind::rotation);
  motion.speed = angular_velocity;
  motion.centre = as_vector(centre);
  motion.axis = 1.0;
  return motion;
}

void BeltWall::keys(Parameters& keys) {
  keys.number("speed", speed, required, any, "L/T",
              "of the surface: along from - to on the left of it, to the right on a plane that faces up");
  time_keys(keys);
}

Motion BeltWall::motion() const {
  auto motion = between_times(Motion::Kind::belt);
  motion.speed = speed;
  motion.axis = 1.0;
  return motion;
}

void Piston::piston_keys(Parameters& keys) {
  keys.number("mass", mass, required, positive, "M", "mass of the piston; gravity does not act on it");
  keys.number("drag", drag, not_negative, "M/T", "force against the motion per speed");
  keys.number("surface_speed", surface_speed, 0.0, any, "L/T",
              "its surface runs along it as that of a belt: pressure and shear on one wall");
  time_keys(keys);
}

Motion Piston::piston_motion(Motion::Kind kind) const {
  auto motion = between_times(kind);
  motion.mass = mass;
  motion.drag = drag;
  motion.surface = surface_speed;
  motion.axis = 1.0;
  return motion;
}

void PushedPiston::keys(Parameters& keys) {
  keys.vector("force", force, std::nullopt, "M L/T^2", "force on the piston, which moves along it");
  piston_keys(keys);
}

Motion PushedPiston::motion() const {
  auto motion = piston_motion(Motion::Kind::force);
  motion.direction = direction_of(force);
  motion.force = magnitude(as_vector(force));
  return motion;
}

void SprungPiston::keys(Parameters& keys) {
  keys.vector("velocity", velocity, std::nullopt, "L/T", "velocity of the far end of the spring");
  keys.number("stiffness", stiffness, required, positive, "M/T^2", "stiffness of the spring");
  piston_keys(keys);
}

Motion SprungPiston::motion() const {
  auto motion = piston_motion(Motion::Kind::spring);
  motion.direction = direction_of(velocity);
  motion.speed = magnitude(as_vector(velocity));
  motion.stiffness = stiffness;
  return motion;
}

Kinds<MotionKind>& motion_kinds() {
  static Kinds<MotionKind> kinds{
      {StandingWall{}, DrivenWall{}, VibratingWall{}, RotatingWall{}, BeltWall{}, PushedPiston{}, SprungPiston{}}};
  return kinds;
}

}  // namespace repose
