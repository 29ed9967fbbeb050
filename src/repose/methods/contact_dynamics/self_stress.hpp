// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose::contact_dynamics {

/// The multiple of a change at which friction reaches its limit: the smallest root x of |T + x dT| = mu (R + x dR).
/// Infinite if friction never reaches it, or is at its limit already.
template <class Vector>
double multiple_to_friction_limit(const Vector& impulse, const Vector& change, double coefficient, double normal,
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

/// The multiple at which the torque reaches its limit: that of rolling, or in 3D of twisting.
inline double multiple_to_roll(const ContactLine<2>& c, const Impulse<2>& p, const Impulse<2>& change) {
  return multiple_to_friction_limit(p.roll, change.roll, c.rolling_friction, p.normal, change.normal);
}
inline double multiple_to_roll(const ContactLine<3>& c, const Impulse<3>& p, const Impulse<3>& change) {
  const double twist = dot(p.roll, c.normal);
  const double twist_change = dot(change.roll, c.normal);
  return std::min(
      multiple_to_friction_limit(Vec<3>(p.roll - c.normal * twist), Vec<3>(change.roll - c.normal * twist_change),
                                 c.rolling_friction, p.normal, change.normal),
      multiple_to_friction_limit(twist, twist_change, c.twisting.friction, p.normal, change.normal));
}

/// The largest multiple of a change of impulse up to which the contact does not open, slide, roll or twist.
template <int D>
double largest_multiple(const ContactLine<D>& c, const Impulse<D>& p, const Impulse<D>& change) {
  double multiple = std::numeric_limits<double>::infinity();
  if (!(p.normal > 0.0)) return multiple;
  if (change.normal < 0.0) multiple = std::min(multiple, -p.normal / change.normal);
  multiple =
      std::min(multiple, multiple_to_friction_limit(p.tangent, change.tangent, c.friction, p.normal, change.normal));
  return std::min(multiple, multiple_to_roll(c, p, change));
}

/// Twice the kinetic energy [M L^2/T^2] that a change of impulse gives if it acts on its contact alone. The sum over
/// contacts is the reference for the kinetic energy of all changes together.
template <int D, class T>
REPOSE_FN T separate_energy(const ContactLine<D, T>& c, const Impulse<D, T>& change) {
  return change.normal * change.normal / c.normal_mass + inner(change.tangent, change.tangent) / c.tangent_mass +
         inner(change.roll, change.roll) / c.roll_mass;
}

}  // namespace repose::contact_dynamics
