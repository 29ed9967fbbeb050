// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/slider.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>

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

/// As of the linear law, with the stiffness of the largest normal load.
inline double surface_stiffness(const Mindlin& law, double normal_stiffness, double /*mass*/, const Inertia& inertia) {
  return inertia.at_rim() * law.ratio * normal_stiffness;
}

template <class T, class Tangential>
REPOSE_FN Tangential tangential_force(const Mindlin& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                      const Tangential& slip_velocity, const std::type_identity_t<T>& dt,
                                      Tangential& slip) {
  const T before = touch.overlap - touch.closing_speed * dt;
  slip = slip * choose(before < touch.overlap, root(positive_part(before) / touch.overlap), T(1.0));
  const T stiffness = law.ratio * normal.stiffness;
  const T dashpot = (2.0 * law.damping) * root(stiffness * touch.mass);
  const T limit = law.friction * positive_part(normal.total);
  const Tangential force = slider_force(stiffness, T(1.0) / stiffness, dashpot, limit, slip_velocity, dt, slip);
  const auto touches = touch.overlap > T(0.0);
  slip = choose(touches, slip, Tangential{});
  return choose(touches, force, Tangential{});
}

/// The slip displacement becomes shorter while the overlap grows, as in `tangential_force`.
template <class T, class Tangential>
REPOSE_FN Tangential displaced(const Mindlin&, const Touch<T>& touch, const Tangential& slip_velocity,
                               const std::type_identity_t<T>& dt, const Tangential& slip) {
  const Tangential moved = slip + slip_velocity * dt;
  const T later = touch.overlap + touch.closing_speed * dt;
  return moved * choose(later > touch.overlap, root(positive_part(touch.overlap) / later), T(1.0));
}

template <class T>
REPOSE_FN T coulomb_limit(const Mindlin& law, const NormalForce<T>& normal) {
  return law.friction * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Mindlin& law, const Touch<double>&, const NormalForce<double>& normal,
                     const Tangential& slip) {
  return 0.5 * law.ratio * normal.stiffness * squared(slip);
}

}  // namespace repose
