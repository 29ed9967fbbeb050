// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/tangential/limit.hpp"

namespace repose {

/// The force [M L/T^2] of a spring and a dashpot in parallel, capped at `limit`. Advances `displacement` [L] by dt;
/// while the contact slides, it keeps the value that gives the capped force.
template <class Tangential>
REPOSE_FN Tangential slider_force(double stiffness, double dashpot, double limit, const Tangential& velocity, double dt,
                                  Tangential& displacement) {
  displacement = displacement + velocity * dt;
  const Tangential damping = velocity * -dashpot;
  const Tangential wanted = damping - displacement * stiffness;
  if (!(magnitude(wanted) > limit)) return wanted;
  const Tangential force = limited(wanted, limit);
  displacement = (damping - force) * (1.0 / stiffness);
  return force;
}

}  // namespace repose
