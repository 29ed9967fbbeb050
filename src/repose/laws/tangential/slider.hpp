// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/tangential/limit.hpp"

#include <type_traits>

namespace repose {

/// The force [M L/T^2] of a spring and a dashpot in parallel, capped at `limit`. The compliance is 1 / stiffness.
/// Advances `displacement` [L] by dt; while the contact slides, it keeps the value that gives the capped force.
template <class T, class Tangential>
REPOSE_FN Tangential slider_force(const std::type_identity_t<T>& stiffness, const std::type_identity_t<T>& compliance,
                                  const T& dashpot, const T& limit, const Tangential& velocity,
                                  const std::type_identity_t<T>& dt, Tangential& displacement) {
  const Tangential moved = displacement + velocity * dt;
  const Tangential damping = velocity * -dashpot;
  const Tangential wanted = damping - moved * stiffness;
  const auto slides = magnitude(wanted) > limit;
  const Tangential force = choose(slides, limited(wanted, limit), wanted);
  displacement = choose(slides, Tangential((damping - force) * compliance), moved);
  return force;
}

}  // namespace repose
