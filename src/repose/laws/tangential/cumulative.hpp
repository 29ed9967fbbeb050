// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/limit.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>

namespace repose {

/// Friction from the slip displacement delta of the contact zone. It softens towards the Coulomb limit.
///
///     d(delta)/dt = v_t,  |delta| <= d_max = alpha mu (engagement)
///     F = -sign(delta) mu F_e [1 - (1 - |delta|/d_max)^(3/2)] - C_T d(delta)/dt,  |F| <= mu F_e
///
/// with C_T = sqrt(m k_T), k_T the slope of the elastic part, F_e the elastic normal force. The slip displacement
/// itself is clamped in every step, also when d_max decreases: clamping the force alone leaves back-slip and lets heaps
/// collapse.
/// Source: Baxter et al. (1997), eqs. (4)-(8).
/// Validated by tests/validation/soft_exact_test.cpp (slip limit, clamp, cap).
struct Cumulative {
  double friction = 0.5;  ///< mu >= 0
  double alpha = 1.214;   ///< d_max divided by mu times the normal engagement, > 0

  static constexpr std::string_view name = "cumulative";
};

inline void parameters(Cumulative& law, Parameters& to, const LawScales& scales) {
  to.number("alpha", law.alpha, 1.214, positive, "", "largest slip displacement over friction times normal engagement");
  law.friction = scales.friction;
}

/// No stiffness beside the normal one limits the time step: the law's slope follows the normal stiffness and stays
/// below it.
inline double surface_stiffness(const Cumulative&, double, double, const Inertia&) { return 0.0; }

/// The tangential force [M L/T^2]. Advances the slip displacement `slip` [L] by one step at the slip velocity [L/T].
/// `normal` is the normal force at the same time.
template <class T, class Tangential>
REPOSE_FN Tangential tangential_force(const Cumulative& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                      const Tangential& slip_velocity, const std::type_identity_t<T>& dt,
                                      Tangential& slip) {
  const T furthest = (law.alpha * law.friction) * touch.engagement;
  slip = limited(Tangential(slip + slip_velocity * dt), furthest);
  const T limit = law.friction * normal.elastic;
  const T inverse = T(1.0) / furthest;
  const T rest = positive_part(1.0 - magnitude(slip) * inverse);
  const T root_of_rest = root(rest);
  const T stiffness = 1.5 * limit * inverse * root_of_rest;
  const T dashpot = root(touch.mass * stiffness);
  const Tangential elastic = direction(slip) * (-limit * (1.0 - rest * root_of_rest));
  return choose(furthest > T(0.0), limited(Tangential(elastic - slip_velocity * dashpot), limit), Tangential{});
}

/// The largest tangential force that the law allows [M L/T^2].
template <class T>
REPOSE_FN T coulomb_limit(const Cumulative& law, const NormalForce<T>& normal) {
  return law.friction * normal.elastic;
}

template <class Tangential>
double stored_energy(const Cumulative& law, const Touch<double>& touch, const NormalForce<double>& normal,
                     const Tangential& slip) {
  const double furthest = law.alpha * law.friction * touch.engagement;
  if (!(furthest > 0.0)) return 0.0;
  const double rest = positive_part(1.0 - magnitude(slip) / furthest);
  return law.friction * normal.elastic * (magnitude(slip) - 0.4 * furthest * (1.0 - rest * rest * std::sqrt(rest)));
}

}  // namespace repose
