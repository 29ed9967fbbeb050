// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/reproducible_math.hpp"
#include "repose/laws/normal/damping.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>

namespace repose {

/// F = k overlap^(3/2), with a dashpot relative to the local stiffness (3/2) k overlap^(1/2), so that restitution does
/// not depend on the speed of an impact. Source: Bratberg (2003), eq. (55).
/// Validated by tests/unit/impact_test.cpp (peak force and contact time of an impact, restitution).
struct Hertz {
  double stiffness = 5000.0;  ///< [M/(L^(1/2) T^2)] > 0
  double damping = 0.5;       ///< >= 0; its meaning depends on damping_kind
  bool attraction = false;    ///< whether the dashpot may make the total force attractive
  DampingKind damping_kind = DampingKind::of_critical;
  double restitution = 0.0;  ///< requested restitution, if damping_kind is restitution

  static constexpr std::string_view name = "hertz";
  static constexpr bool restitution_depends_on_speed = false;
};

inline void parameters(Hertz& law, Parameters& to, const LawScales& scales) {
  to.number("stiffness", law.stiffness,
            {5000.0 * scales.weight / reproducible::pow(scales.diameter, 1.5), "5000 m g/d^(3/2)"}, positive,
            "M/(L^(1/2) T^2)", "k of F = k overlap^(3/2)");
  damping_parameters(law, to, scales);
}

REPOSE_FN double reach(const Hertz&) { return 1.0; }

/// For a law whose stiffness k may differ from pair to pair.
template <class Law, class T>
REPOSE_FN NormalForce<T> hertz_force(const Law& law, const T& k, const Touch<T>& touch) {
  const T width = root(positive_part(touch.overlap));
  const T elastic = k * touch.overlap * width;
  const T stiffness = 1.5 * k * width;
  const T viscous = dashpot(law, touch, root(stiffness)) * touch.closing_speed;
  return {elastic, without_attraction(law.attraction, elastic + viscous), stiffness};
}
template <class T>
REPOSE_FN NormalForce<T> normal_force(const Hertz& law, const Touch<T>& touch) {
  return hertz_force(law, T(law.stiffness), touch);
}

/// Energy [M L^2/T^2] stored in a pair with mean diameter `diameter` at `distance`.
inline double elastic_energy(const Hertz& law, double /*mass*/, double diameter, double distance) {
  const double overlap = diameter > distance ? diameter - distance : 0.0;
  return 0.4 * law.stiffness * overlap * overlap * std::sqrt(overlap);
}

/// Stiffness -dF/dr [M/T^2] at the distance where the pair stores `energy`.
inline double stiffness_at(const Hertz& law, double /*mass*/, double /*diameter*/, double energy) {
  return 1.5 * law.stiffness * reproducible::pow(energy / (0.4 * law.stiffness), 0.2);
}

}  // namespace repose
