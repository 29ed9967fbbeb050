// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

namespace repose::contact_dynamics {

// Relaxation of one contact (T = double) or of several that share no moving body, side by side (T = a vector of them).

/// The largest frictional impulse under this normal impulse; 0 without a normal impulse, even if the coefficient is
/// infinite.
template <class T>
REPOSE_FN T friction_limit(const T& coefficient, const T& normal_impulse) {
  return choose(normal_impulse > 0.0, T(coefficient * normal_impulse), T{});
}

/// The change, reduced so that the impulse after it is at most `limit`. If it stays within the limit, it is returned to
/// the bit.
template <class T>
REPOSE_FN T change_within(const T& impulse, const T& change, const T& limit) {
  return smaller(larger(change, T(-limit - impulse)), T(limit - impulse));
}

/// Changes the normal and tangential impulse of a contact to those that solve it with all other contacts unchanged.
/// Only the given fraction of the change of friction is applied. Adds the changes to `change`.
template <int D, class T, class Bodies>
REPOSE_FN void relax_translation(const Bodies& among, const T& fraction, ContactLine<D, T>& c, Body<D, T>& a,
                                 Body<D, T>& b, Impulse<D, T>& change) {
  auto& p = c.impulse;
  const T opening = opening_velocity(c, a, b) + c.normal_bias;
  const TangentOf<D, T> slip = slip_velocity(c, a, b) + c.tangent_bias;
  const T normal = larger(T(-p.normal), T(-c.normal_mass * opening));
  p.normal += normal;
  const T limit = friction_limit(c.friction, p.normal);
  const TangentOf<D, T> tangent = change_within(p.tangent, TangentOf<D, T>(slip * -c.tangent_mass), limit) * fraction;
  p.tangent += tangent;
  among.push(c, normal, tangent, a, b);
  change.normal += normal;
  change.tangent += tangent;
}

/// The change of the torque impulse, within its limits. In 3D rolling and twisting have one each.
template <int D, class T>
REPOSE_FN SpinOf<D, T> roll_change(const ContactLine<D, T>& c, const SpinOf<D, T>& relative) {
  const auto& p = c.impulse;
  const T limit = friction_limit(c.rolling_friction, p.normal);
  if constexpr (D == 2) {
    return change_within(p.roll, SpinOf<D, T>(relative * -c.roll_mass), limit);
  } else {
    const double twist = dot(p.roll, c.normal);
    const double twisting = dot(relative, c.normal);
    const Vec<3> rolled = repose::change_within(Vec<3>(p.roll - c.normal * twist),
                                                Vec<3>((relative - c.normal * twisting) * -c.roll_mass), limit);
    const double twisted = change_within(twist, -c.roll_mass * twisting, friction_limit(c.twisting.friction, p.normal));
    return rolled + c.normal * twisted;
  }
}

/// Does the same for the rolling impulse, at the present normal impulse.
template <int D, class T, class Bodies>
REPOSE_FN void relax_roll(const Bodies& among, ContactLine<D, T>& c, Body<D, T>& a, Body<D, T>& b,
                          Impulse<D, T>& change) {
  const SpinOf<D, T> roll = roll_change(c, roll_velocity(c, a, b));
  c.impulse.roll += roll;
  among.turn(c, roll, a, b);
  change.roll += roll;
}

}  // namespace repose::contact_dynamics
