// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose::contact_dynamics {

/// How often impulses may change like this before friction meets its limit; infinite where it never does or does
/// already: the smallest root of |T + x dT| = mu (R + x dR).
template <class Vector>
double room_of_friction(const Vector& impulse, const Vector& change, double coefficient, double normal,
                        double normal_change) {
  const double limit = friction_limit(coefficient, normal);
  if (!std::isfinite(limit) || magnitude(impulse) >= limit * (1.0 - 1e-9)) {
    return std::numeric_limits<double>::infinity();
  }
  const double square = coefficient * coefficient;
  const double a = repose::squared(change) - square * normal_change * normal_change;
  const double b = 2.0 * (inner(impulse, change) - square * normal * normal_change);
  const double c = repose::squared(impulse) - limit * limit;
  const double root = b * b - 4.0 * a * c;
  if (root < 0.0 || !(b + std::sqrt(root) > 0.0)) return std::numeric_limits<double>::infinity();
  return -2.0 * c / (b + std::sqrt(root));
}

/// How often the impulse of a contact may change like this before it opens, slides or rolls.
template <int D>
double room_along(const ContactLine<D>& c, const Impulse<D>& p, const Impulse<D>& change) {
  double room = std::numeric_limits<double>::infinity();
  if (!(p.normal > 0.0)) return room;
  if (change.normal < 0.0) room = std::min(room, -p.normal / change.normal);
  room = std::min(room, room_of_friction(p.tangent, change.tangent, c.friction, p.normal, change.normal));
  return std::min(room, room_of_friction(p.roll, change.roll, c.rolling_friction, p.normal, change.normal));
}

/// Twice the energy [M L^2/T^2] that a change of impulse would have if it acted on its contact alone: what the kinetic
/// energy of the velocities of all changes is to be compared with.
template <int D>
double energy_apart(const ContactLine<D>& c, const Impulse<D>& change) {
  return change.normal * change.normal / c.normal_mass + repose::squared(change.tangent) / c.tangent_mass +
         repose::squared(change.roll) / c.roll_mass;
}

}  // namespace repose::contact_dynamics
