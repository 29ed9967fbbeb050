// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"
#include "repose/laws/tangential/limit.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>

namespace repose {

/// Linear tangential spring and dashpot with a Coulomb cap; while the contact slides the spring keeps the length that
/// gives the capped force. Source: Cundall & Strack (1979).
/// Validated by tests/unit/laws_test.cpp and, against another program, by benchmarks/run.py (same bed, same law).
struct Linear {
  double friction = 0.5;   ///< mu >= 0
  double stiffness = 100;  ///< [M/T^2] > 0
  double damping = 0.0;    ///< fraction of the critical damping of one grain's translation, >= 0
};

template <class Tangential>
REPOSE_FN Tangential tangential_force(const Linear& law, const Touch<double>& touch, const NormalForce<double>& normal,
                                      const Tangential& slip_velocity, double dt, Tangential& delta) {
  delta = delta + slip_velocity * dt;
  const double dashpot = 2.0 * law.damping * std::sqrt(law.stiffness) * std::sqrt(touch.mass);
  const Tangential damping = slip_velocity * -dashpot;
  const Tangential wanted = damping - delta * law.stiffness;
  const double limit = law.friction * positive_part(normal.total);
  if (!(magnitude(wanted) > limit)) return wanted;
  const Tangential force = limited(wanted, limit);
  delta = (damping - force) * (1.0 / law.stiffness);
  return force;
}

REPOSE_FN double coulomb_limit(const Linear& law, const NormalForce<double>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Linear& law, const Touch<double>&, const NormalForce<double>&, const Tangential& delta) {
  return 0.5 * law.stiffness * squared(delta);
}

}  // namespace repose
