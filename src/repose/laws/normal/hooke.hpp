// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/normal/damping.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/touch.hpp"

#include <string_view>

namespace repose {

/// Linear spring F = k overlap with a dashpot. A grain at rest on a fixed grain of its size sits at r = s - m g / k.
/// Source: Baxter et al. (1997), section III; Cundall & Strack (1979).
/// Validated by tests/validation/soft_exact_test.cpp (rest distance; energy error of an impact against the time step).
struct Hooke {
  double stiffness = 500.0;  ///< [M/T^2] > 0
  double damping = 0.5;      ///< >= 0; its meaning depends on damping_kind
  bool attraction = false;   ///< whether the dashpot may make the total force attractive
  DampingKind damping_kind = DampingKind::of_critical;
  double restitution = 0.0;  ///< requested restitution, if damping_kind is restitution

  static constexpr std::string_view name = "hooke";
  static constexpr bool restitution_depends_on_speed = false;
};

inline void parameters(Hooke& law, Parameters& to, const LawScales& scales) {
  to.number("stiffness", law.stiffness, {500.0 * scales.weight / scales.diameter, "500 m g/d"}, positive, "M/T^2",
            "spring constant k");
  damping_parameters(law, to, scales);
}

REPOSE_FN double reach(const Hooke&) { return 1.0; }

template <class T>
REPOSE_FN NormalForce<T> normal_force(const Hooke& law, const Touch<T>& touch) {
  const T elastic = law.stiffness * touch.overlap;
  const T viscous = dashpot(law, touch, root(law.stiffness)) * touch.closing_speed;
  return {elastic, without_attraction(law.attraction, elastic + viscous), T(law.stiffness)};
}

/// Energy [M L^2/T^2] stored in a pair with mean diameter `diameter` at `distance`.
inline double elastic_energy(const Hooke& law, double /*mass*/, double diameter, double distance) {
  const double overlap = diameter > distance ? diameter - distance : 0.0;
  return 0.5 * law.stiffness * overlap * overlap;
}

inline double stiffness_at(const Hooke& law, double /*mass*/, double /*diameter*/, double /*energy*/) {
  return law.stiffness;
}

}  // namespace repose
