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
  double attraction = 0.0;     ///< [M L/T^2] of cohesion, to be taken off the normal force
  Tangential tangential{};     ///< [M L/T^2]
  Tangential rolling{};        ///< [M L/T^2] rolling torque over the roll radius; the second grain feels the opposite
};

/// What a contact remembers [L]: displacements in its tangent plane.
template <class Tangential>
struct ContactHistory {
  Tangential slip{};
  Tangential roll{};
};

/// All laws of a touching pair; its history goes forward by dt. The roll velocity is the roll radius times the
/// difference of the angular velocities, first less second. Friction and rolling resistance follow the force that
/// presses the grains together, which cohesion does not lessen.
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
