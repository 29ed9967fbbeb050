// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/limit.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// Friction from the accumulated displacement of the contact zone, softening towards the Coulomb limit.
///
///     d(delta)/dt = v_t,  |delta| <= d_max = alpha mu (engagement)
///     F = -sign(delta) mu F_e [1 - (1 - |delta|/d_max)^(3/2)] - C_T d(delta)/dt,  |F| <= mu F_e
///
/// with C_T = sqrt(m k_T), k_T the slope of the elastic part. The displacement itself is clamped, every step and also
/// when d_max shrinks: clamping the force alone leaves back-slip and lets heaps collapse.
/// Source: Baxter et al. (1997), eqs. (4)-(8). Validated by tests/validation/soft_exact.cpp (slip limit, clamp, cap).
struct Cumulative {
  double friction = 0.5;  ///< mu >= 0
  double alpha = 1.214;   ///< d_max over mu times the normal engagement, > 0

  static constexpr std::string_view name = "cumulative";
};

inline void parameters(Cumulative& law, Parameters& to, const LawScales& scales) {
  to.number("alpha", law.alpha, 1.214, positive, "", "largest displacement over friction times normal engagement");
  law.friction = scales.friction;
}

/// The law's own slope follows the normal stiffness and stays below it.
inline double surface_stiffness(const Cumulative&, double, double) { return 0.0; }

/// The force [M L/T^2] along the tangent; brings the displacement delta [L] forward by one step at slip velocity v_t.
/// `normal` is the normal force of the same moment.
template <class Tangential>
REPOSE_FN Tangential tangential_force(const Cumulative& law, const Touch<double>& touch,
                                      const NormalForce<double>& normal, const Tangential& slip_velocity, double dt,
                                      Tangential& delta) {
  const double furthest = law.alpha * law.friction * touch.engagement;
  delta = limited(delta + slip_velocity * dt, furthest);
  if (!(furthest > 0.0)) return Tangential{};
  const double limit = law.friction * normal.elastic;
  const double inverse = 1.0 / furthest;
  const double rest = positive_part(1.0 - magnitude(delta) * inverse);
  const double root = std::sqrt(rest);
  const double stiffness = 1.5 * limit * inverse * root;
  const double dashpot = std::sqrt(touch.mass * stiffness);
  return limited(direction(delta) * (-limit * (1.0 - rest * root)) - slip_velocity * dashpot, limit);
}

/// The largest tangential force that the law allows [M L/T^2].
REPOSE_FN double coulomb_limit(const Cumulative& law, const NormalForce<double>& normal) {
  return law.friction * normal.elastic;
}

template <class Tangential>
double stored_energy(const Cumulative& law, const Touch<double>& touch, const NormalForce<double>& normal,
                     const Tangential& delta) {
  const double furthest = law.alpha * law.friction * touch.engagement;
  if (!(furthest > 0.0)) return 0.0;
  const double rest = positive_part(1.0 - magnitude(delta) / furthest);
  return law.friction * normal.elastic * (magnitude(delta) - 0.4 * furthest * (1.0 - rest * rest * std::sqrt(rest)));
}

}  // namespace repose
