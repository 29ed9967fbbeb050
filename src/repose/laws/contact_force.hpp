// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

namespace repose {

/// The two forces of one contact.
template <class Tangential>
struct ContactForce {
  NormalForce<double> normal;
  Tangential tangential;
};

/// Both laws of a touching pair; the tangential displacement `delta` goes forward by dt.
template <class Normal, class Tangential_law, class Tangential>
REPOSE_FN ContactForce<Tangential> contact_force(const PairLaw<Normal, Tangential_law>& law, const Touch<double>& touch,
                                                 const Tangential& slip_velocity, double dt, Tangential& delta) {
  const NormalForce<double> normal = normal_force(law.normal, touch);
  return {normal, tangential_force(law.tangential, touch, normal, slip_velocity, dt, delta)};
}

}  // namespace repose
