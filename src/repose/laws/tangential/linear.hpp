// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/slider.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// Linear tangential spring and dashpot with a Coulomb cap; while the contact slides the spring keeps the length that
/// gives the capped force. Source: Cundall & Strack (1979).
/// Validated by tests/unit/laws_test.cpp and, against another program, by benchmarks/run.py (same bed, same law).
struct Linear {
  double friction = 0.5;   ///< mu >= 0
  double stiffness = 100;  ///< [M/T^2] > 0
  double damping = 0.0;    ///< fraction of the critical damping of one grain's translation, >= 0

  static constexpr std::string_view name = "linear";
};

inline void parameters(Linear& law, Parameters& to, const LawScales& scales) {
  to.number("stiffness", law.stiffness, required, positive, "M/T^2", "spring constant k_t");
  to.number("damping", law.damping, 0.0, not_negative, "", "fraction of critical");
  law.friction = scales.friction;
}

/// Stiffness [M/T^2] that the surface of a grain feels, rotation included: it is three times as light as the centre.
inline double surface_stiffness(const Linear& law, double /*normal_stiffness*/, double /*mass*/) {
  return 3.0 * law.stiffness;
}

template <class Tangential>
REPOSE_FN Tangential tangential_force(const Linear& law, const Touch<double>& touch, const NormalForce<double>& normal,
                                      const Tangential& slip_velocity, double dt, Tangential& delta) {
  const double dashpot = 2.0 * law.damping * std::sqrt(law.stiffness) * std::sqrt(touch.mass);
  return slider_force(law.stiffness, dashpot, law.friction * positive_part(normal.total), slip_velocity, dt, delta);
}

REPOSE_FN double coulomb_limit(const Linear& law, const NormalForce<double>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Linear& law, const Touch<double>&, const NormalForce<double>&, const Tangential& delta) {
  return 0.5 * law.stiffness * squared(delta);
}

}  // namespace repose
