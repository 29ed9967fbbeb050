// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/slider.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// The tangential spring of a Hertz contact, capped at the Coulomb limit. Its stiffness is a fixed fraction of the
/// normal stiffness, which is proportional to the square root of the overlap.
///
/// When the overlap grows, the force is kept and the slip displacement is reduced; when it shrinks, the displacement is
/// kept and the force decreases. If the displacement were always kept, pressing a sheared contact would create energy.
/// Source: Mindlin & Deresiewicz (1953) as simplified by Thornton & Yin (1991).
/// Validated by tests/unit/impact_test.cpp (stiffness) and tests/contract/laws_contract_test.cpp (no energy from
/// cycles).
struct Mindlin {
  double friction = 0.5;  ///< mu >= 0
  double ratio = 0.82;    ///< tangential over normal stiffness, > 0: 2 (1 - nu) / (2 - nu), 0.82 for nu = 0.3
  double damping = 0.0;   ///< fraction of the critical damping of one grain's translation, >= 0

  static constexpr std::string_view name = "mindlin";
};

inline void parameters(Mindlin& law, Parameters& to, const LawScales& scales) {
  to.number("ratio", law.ratio, scales.ratio, positive, "",
            "tangential over normal stiffness: 2 (1 - nu) / (2 - nu), nu Poisson's ratio; follows from poisson_ratio");
  to.number("damping", law.damping, 0.0, not_negative, "", "fraction of critical damping");
  law.friction = scales.friction;
}

inline double surface_stiffness(const Mindlin& law, double normal_stiffness, double /*mass*/) {
  return 3.0 * law.ratio * normal_stiffness;
}

template <class Tangential>
REPOSE_FN Tangential tangential_force(const Mindlin& law, const Touch<double>& touch, const NormalForce<double>& normal,
                                      const Tangential& slip_velocity, double dt, Tangential& slip) {
  if (!(touch.overlap > 0.0)) {
    slip = Tangential{};
    return slip;
  }
  const double before = touch.overlap - touch.closing_speed * dt;
  if (before < touch.overlap) slip = slip * std::sqrt(positive_part(before) / touch.overlap);
  const double stiffness = law.ratio * normal.stiffness;
  const double dashpot = 2.0 * law.damping * std::sqrt(stiffness * touch.mass);
  return slider_force(stiffness, dashpot, law.friction * positive_part(normal.total), slip_velocity, dt, slip);
}

/// The slip displacement becomes shorter while the overlap grows, as in `tangential_force`.
template <class Tangential>
REPOSE_FN Tangential displaced(const Mindlin&, const Touch<double>& touch, const Tangential& slip_velocity, double dt,
                               const Tangential& slip) {
  const Tangential moved = slip + slip_velocity * dt;
  const double later = touch.overlap + touch.closing_speed * dt;
  return later > touch.overlap ? moved * std::sqrt(positive_part(touch.overlap) / later) : moved;
}

REPOSE_FN double coulomb_limit(const Mindlin& law, const NormalForce<double>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Mindlin& law, const Touch<double>&, const NormalForce<double>& normal,
                     const Tangential& slip) {
  return 0.5 * law.ratio * normal.stiffness * squared(slip);
}

}  // namespace repose
