// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <type_traits>

namespace repose {

/// The parameter by which the dashpot of a normal law is given. The force of the dashpot is C times the closing speed.
enum class DampingKind {
  of_critical,  ///< C = 2 z sqrt(m_ij k), m_ij of nominal masses: z of critical for a grain against a fixed one
  restitution,  ///< C = 2 z sqrt(m_red k), m_red the true reduced mass: z gives impacts the requested restitution
  viscosity     ///< C = d m_red. Source: Bratberg (2003), eq. (57)
};

/// The coefficient C [M/T] for a stiffness whose root is given [M^(1/2)/T]. law.damping is z or d, depending on
/// law.damping_kind, which is the same for all pairs of a law. With the roots of mass and stiffness apart, that of a
/// constant stiffness is taken once.
template <class Law, class T>
REPOSE_FN T dashpot(const Law& law, const Touch<T>& touch, const std::type_identity_t<T>& root_of_stiffness) {
  if (law.damping_kind == DampingKind::of_critical) [[likely]] {
    return (2.0 * law.damping) * root_of_stiffness * root(touch.mass);
  }
  if (law.damping_kind == DampingKind::viscosity) return law.damping * touch.reduced_mass();
  return (2.0 * law.damping) * root_of_stiffness * root(touch.reduced_mass());
}

/// The parameters of the dashpot. If a restitution is given, `with_restitution` (impact.hpp) sets law.damping later.
template <class Law>
void damping_parameters(Law& law, Parameters& parameters, const LawScales& scales) {
  auto given_as = static_cast<std::size_t>(law.damping_kind);
  double given = law.damping_kind == DampingKind::restitution ? law.restitution : law.damping;
  parameters.one_of({{"damping", not_negative, "", "fraction of the critical damping of a grain against a fixed one"},
                     {"restitution",
                      {.low = 0.0, .high = 1.0, .low_allowed = false},
                      "",
                      "speed after a head-on impact over speed before, for all sizes and partners"},
                     {"viscosity", not_negative, "1/T", "dashpot coefficient over reduced mass"}},
                    given_as, given, 0.5);
  law.damping_kind = static_cast<DampingKind>(given_as);
  if (law.damping_kind == DampingKind::restitution) {
    law.restitution = given;
    if constexpr (Law::restitution_depends_on_speed) {
      parameters.number("impact_speed", law.impact_speed,
                        {std::sqrt(2.0 * scales.gravity * scales.diameter), "sqrt(2 g d)"}, positive, "L/T",
                        "speed of the impact that has this restitution");
    }
  } else {
    law.damping = given;
  }
  parameters.flag("attraction", law.attraction, false, "whether the dashpot may make the force attractive");
}

}  // namespace repose
