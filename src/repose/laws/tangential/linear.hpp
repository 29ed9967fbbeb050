// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/slider.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>

namespace repose {

/// Linear tangential spring and dashpot, capped at the Coulomb limit. While the contact slides, the slip displacement
/// keeps the value that gives the capped force. Source: Cundall & Strack (1979).
/// Validated by tests/unit/laws_test.cpp and, against another program, by benchmarks/run.py (same bed, same law).
struct Linear {
  double friction = 0.5;   ///< mu >= 0
  double stiffness = 100;  ///< [M/T^2] > 0
  double damping = 0.0;    ///< fraction of the critical damping of one grain's translation, >= 0

  static constexpr std::string_view name = "linear";
};

inline void parameters(Linear& law, Parameters& to, const LawScales& scales) {
  to.number("stiffness", law.stiffness, required, positive, "M/T^2", "spring constant k_t");
  to.number("damping", law.damping, 0.0, not_negative, "", "fraction of critical damping");
  law.friction = scales.friction;
}

/// The effective stiffness [M/T^2] for the time step, k_t (1 + m R^2 / I): a force at the rim of a free disc meets a
/// third of its mass, since it also rotates the disc.
inline double surface_stiffness(const Linear& law, double /*normal_stiffness*/, double /*mass*/,
                                const Inertia& inertia) {
  return inertia.at_rim() * law.stiffness;
}

template <class T, class Tangential>
REPOSE_FN Tangential tangential_force(const Linear& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                      const Tangential& slip_velocity, const std::type_identity_t<T>& dt,
                                      Tangential& slip) {
  const T dashpot = (2.0 * law.damping * root(law.stiffness)) * root(touch.mass);
  return slider_force(T(law.stiffness), T(1.0 / law.stiffness), dashpot, law.friction * positive_part(normal.total),
                      slip_velocity, dt, slip);
}

template <class T>
REPOSE_FN T coulomb_limit(const Linear& law, const NormalForce<T>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Linear& law, const Touch<double>&, const NormalForce<double>&, const Tangential& slip) {
  return 0.5 * law.stiffness * squared(slip);
}

}  // namespace repose
