// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/pair_law.hpp"
#include "repose/laws/touch.hpp"

namespace repose {

/// The forces of one contact on its first grain.
template <class Tangential>
struct ContactForce {
  NormalForce<double> normal;  ///< without cohesion
  double attraction = 0.0;     ///< [M L/T^2] cohesive force, >= 0, to be subtracted from the normal force
  Tangential tangential{};     ///< [M L/T^2]
  Tangential rolling{};        ///< [M L/T^2] rolling torque divided by the roll radius; opposite on the second grain
};

/// The displacements [L] in its tangent plane that a contact accumulates.
template <class Tangential>
struct ContactHistory {
  Tangential slip{};  ///< slip displacement
  Tangential roll{};  ///< rolling displacement
};

/// Evaluates all laws of a pair in reach, and advances its history by dt. The roll velocity is the roll radius times
/// the angular velocity of the first grain minus that of the second. Friction and rolling resistance depend on the
/// normal force without cohesion.
template <class Law, class Tangential>
REPOSE_FN ContactForce<Tangential> contact_force(const Law& law, const Touch<double>& touch,
                                                 const Tangential& slip_velocity, const Tangential& roll_velocity,
                                                 double dt, ContactHistory<Tangential>& history) {
  ContactForce<Tangential> force{normal_force(law.normal, touch), attraction(law.cohesion, touch), {}, {}};
  force.tangential = tangential_force(law.tangential, touch, force.normal, slip_velocity, dt, history.slip);
  force.rolling = rolling_force(law.rolling, touch, force.normal, roll_velocity, dt, history.roll);
  return force;
}

}  // namespace repose
