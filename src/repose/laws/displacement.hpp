// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"
#include "repose/laws/touch.hpp"

#include <type_traits>

namespace repose {

/// How the displacements of a contact advance in a step whose velocities are those of the time of the force. Half of
/// the step lies before the force and half behind it, so that the sum is the trapezoidal rule, of second order.
struct HalfSteps {
  double before = 0.0;  ///< [T] from the time of the displacements to that of the force; 0 in the first step
  double after = 0.0;   ///< [T] from the force to the time of the displacements that the step leaves
};

/// The displacement [L] after a contact has moved for dt at this velocity [L/T], before friction limits it. A law that
/// keeps no displacement, or scales it, has a function of its own.
template <class Law, class T, class Tangential>
REPOSE_FN Tangential displaced(const Law&, const Touch<T>&, const Tangential& velocity,
                               const std::type_identity_t<T>& dt, const Tangential& displacement) {
  return displacement + velocity * dt;
}

}  // namespace repose
