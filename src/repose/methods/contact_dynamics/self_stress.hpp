// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// How often the impulses may change like this before the first contact opens, slides or rolls.
template <int D>
double room_along(const std::vector<ContactLine<D>>& contacts, const std::vector<Impulse<D>>& changes) {
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& c = contacts[k];
    const auto& p = c.impulse;
    const auto& d = changes[k];
    if (!(p.normal > 0.0)) continue;
    if (d.normal < 0.0) room = std::min(room, -p.normal / d.normal);
    room = std::min(room, room_of_friction(p.tangent, d.tangent, c.friction, p.normal, d.normal));
    room = std::min(room, room_of_friction(p.roll, d.roll, c.rolling_friction, p.normal, d.normal));
  }
  return room;
}

/// Twice the energy [M L^2/T^2] that changes of impulses would have if each acted on its contact alone: what the
/// kinetic energy of their velocities is to be compared with.
template <int D>
double energy_apart(const std::vector<ContactLine<D>>& contacts, const std::vector<Impulse<D>>& changes) {
  double sum = 0.0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& d = changes[k];
    sum += d.normal * d.normal / contacts[k].normal_mass + repose::squared(d.tangent) / contacts[k].tangent_mass +
           repose::squared(d.roll) / contacts[k].roll_mass;
  }
  return sum;
}

}  // namespace repose::contact_dynamics
