// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/limit.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>
#include <type_traits>

namespace repose {

/// Friction proportional to the slip velocity, F = -d m_red v_t, capped at the Coulomb limit. It carries no force at
/// rest, so heaps creep.
/// Source: Bratberg (2003), eq. (58). Validated by tests/unit/laws_test.cpp.
struct Viscous {
  double friction = 0.5;  ///< mu >= 0
  double rate = 0.0;      ///< [1/T] d > 0

  static constexpr std::string_view name = "viscous";
};

inline void parameters(Viscous& law, Parameters& to, const LawScales& scales) {
  to.number("rate", law.rate, required, positive, "1/T", "tangential force over reduced mass and slip velocity");
  law.friction = scales.friction;
}

/// The stiffness [M/T^2], for the time step, of a spring as fast as the dashpot. At the rim, where a free grain has the
/// mass m / (1 + m R^2 / I), that of a pair decays the slip velocity at half of the rate d (1 + m R^2 / I); 3/2 d for
/// discs.
inline double surface_stiffness(const Viscous& law, double /*normal_stiffness*/, double mass, const Inertia& inertia) {
  const double decay = 0.5 * inertia.at_rim();
  return mass * (decay * decay) * law.rate * law.rate;
}

template <class T, class Tangential>
REPOSE_FN Tangential tangential_force(const Viscous& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                      const Tangential& slip_velocity, const std::type_identity_t<T>&, Tangential&) {
  return limited(slip_velocity * (-law.rate * touch.reduced_mass()), law.friction * positive_part(normal.total));
}

template <class T, class Tangential>
REPOSE_FN Tangential displaced(const Viscous&, const Touch<T>&, const Tangential&, double, const Tangential& unmoved) {
  return unmoved;
}

template <class T>
REPOSE_FN T coulomb_limit(const Viscous& law, const NormalForce<T>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Viscous&, const Touch<double>&, const NormalForce<double>&, const Tangential&) {
  return 0.0;
}

}  // namespace repose
