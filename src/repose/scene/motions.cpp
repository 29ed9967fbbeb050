// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/motions.hpp"

namespace repose {

namespace {

using Motion = WallMotion<2>;

Vec<2> vector_of(const std::array<double, 2>& numbers) { return {{numbers[0], numbers[1]}}; }

Vec<2> direction_of(const std::array<double, 2>& numbers) {
  const auto vector = vector_of(numbers);
  return vector * (1.0 / magnitude(vector));
}

void start_key(double& start, Parameters& keys) {
  keys.number("start", start, not_negative, "T", "the wall stands still until then");
}

}  // namespace

void DrivenWall::keys(Parameters& keys) {
  keys.vector("velocity", velocity, std::nullopt, "L/T", "velocity of the wall");
  start_key(start, keys);
}

Motion DrivenWall::motion() const {
  return {.kind = Motion::Kind::velocity,
          .direction = direction_of(velocity),
          .speed = magnitude(vector_of(velocity)),
          .start = start};
}

void Piston::piston_keys(Parameters& keys) {
  keys.number("mass", mass, required, positive, "M", "mass of the piston; gravity does not act on it");
  keys.number("drag", drag, not_negative, "M/T", "force against the motion per speed");
  start_key(start, keys);
}

Motion Piston::piston_motion() const { return {.mass = mass, .drag = drag, .start = start}; }

void PushedPiston::keys(Parameters& keys) {
  keys.vector("force", force, std::nullopt, "M L/T^2", "force on the piston, which moves along it");
  piston_keys(keys);
}

Motion PushedPiston::motion() const {
  auto motion = piston_motion();
  motion.kind = Motion::Kind::force;
  motion.direction = direction_of(force);
  motion.force = magnitude(vector_of(force));
  return motion;
}

void SprungPiston::keys(Parameters& keys) {
  keys.vector("velocity", velocity, std::nullopt, "L/T", "velocity of the far end of the spring");
  keys.number("stiffness", stiffness, required, positive, "M/T^2", "stiffness of the spring");
  piston_keys(keys);
}

Motion SprungPiston::motion() const {
  auto motion = piston_motion();
  motion.kind = Motion::Kind::spring;
  motion.direction = direction_of(velocity);
  motion.speed = magnitude(vector_of(velocity));
  motion.stiffness = stiffness;
  return motion;
}

Kinds<MotionKind>& motion_kinds() {
  static Kinds<MotionKind> kinds{{StandingWall{}, DrivenWall{}, PushedPiston{}, SprungPiston{}}};
  return kinds;
}

}  // namespace repose
