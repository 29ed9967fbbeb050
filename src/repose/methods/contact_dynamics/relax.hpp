// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>

namespace repose::contact_dynamics {

/// Changes the normal and tangential impulse of a contact to those that solve it with all other contacts unchanged.
/// Only the given fraction of the change of friction is applied. Adds the changes to `change`.
template <int D, class Bodies>
REPOSE_FN void relax_translation(const Bodies& among, double fraction, ContactLine<D>& c, Body<D>& a, Body<D>& b,
                                 Impulse<D>& change) {
  auto& p = c.impulse;
  const double opening = opening_velocity(c, a, b) + c.normal_bias;
  const Tangent<D> slip = slip_velocity(c, a, b) + c.tangent_bias;
  const double normal = std::max(-p.normal, -c.normal_mass * opening);
  p.normal += normal;
  const Tangent<D> tangent =
      change_within(p.tangent, Tangent<D>(slip * -c.tangent_mass), friction_limit(c.friction, p.normal)) * fraction;
  p.tangent += tangent;
  among.push(c, normal, tangent, a, b);
  change.normal += normal;
  change.tangent += tangent;
}

/// Does the same for the rolling impulse, at the present normal impulse.
template <int D, class Bodies>
REPOSE_FN void relax_roll(const Bodies& among, ContactLine<D>& c, Body<D>& a, Body<D>& b, Impulse<D>& change) {
  auto& p = c.impulse;
  const Spin<D> roll = change_within(p.roll, Spin<D>(roll_velocity(c, a, b) * -c.roll_mass),
                                     friction_limit(c.rolling_friction, p.normal));
  p.roll += roll;
  among.turn(c, roll, a, b);
  change.roll += roll;
}

}  // namespace repose::contact_dynamics
