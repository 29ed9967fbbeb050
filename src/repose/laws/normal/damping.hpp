// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>

namespace repose {

/// How the dashpot of a normal law is given. Its coefficient is C, its force C times the closing speed.
enum class DampingKind {
  of_critical,  ///< C = 2 z sqrt(m_ij k), m_ij of nominal masses: z of critical for a grain against a fixed one
  restitution,  ///< C = 2 z sqrt(m_red k), m_red the true reduced mass: z is such that impacts have this restitution
  viscosity     ///< C = d m_red. Source: Bratberg (2003), eq. (57)
};

/// The coefficient by the kinds that know the true reduced mass; apart, so that the usual kind pays nothing for them.
[[gnu::noinline, gnu::cold]] inline double dashpot_of_pair(DampingKind kind, double damping, double reduced_mass,
                                                           double stiffness) {
  if (kind == DampingKind::viscosity) return damping * reduced_mass;
  return 2.0 * damping * std::sqrt(reduced_mass * stiffness);
}

/// The coefficient [M/T] for a stiffness k. Of law.damping, which is z or d by law.damping_kind.
template <class Law>
REPOSE_FN double dashpot(const Law& law, const Touch<double>& touch, double stiffness) {
  if (law.damping_kind == DampingKind::of_critical) [[likely]] {
    return 2.0 * law.damping * std::sqrt(touch.mass * stiffness);
  }
  return dashpot_of_pair(law.damping_kind, law.damping, touch.reduced_mass, stiffness);
}

/// The parameters of the dashpot; what restitution means for law.damping is worked out by `completed` (impact.hpp).
template <class Law>
void damping_parameters(Law& law, Parameters& parameters, const LawScales& scales) {
  auto way = static_cast<std::size_t>(law.damping_kind);
  double given = law.damping_kind == DampingKind::restitution ? law.restitution : law.damping;
  parameters.one_of({{"damping", not_negative, "", "fraction of the critical damping of a grain against a fixed one"},
                     {"restitution",
                      {.low = 0.0, .high = 1.0, .low_allowed = false},
                      "",
                      "speed after a head-on impact over speed before, for all sizes and partners"},
                     {"viscosity", not_negative, "1/T", "dashpot over reduced mass"}},
                    way, given, 0.5);
  law.damping_kind = static_cast<DampingKind>(way);
  if (law.damping_kind == DampingKind::restitution) {
    law.restitution = given;
    if constexpr (Law::restitution_depends_on_speed) {
      parameters.number("impact_speed", law.impact_speed, std::sqrt(2.0 * scales.gravity * scales.diameter), positive,
                        "L/T", "at which impacts have that restitution");
    }
  } else {
    law.damping = given;
  }
  parameters.flag("attraction", law.attraction, false, "let the dashpot pull");
}

}  // namespace repose
