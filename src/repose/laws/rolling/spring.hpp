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

/// Resistance to rolling: an elastic spring builds up a torque as the grains roll on each other, and yields at mu_r R N
/// (R: roll radius, N: normal force). It is the soft counterpart of rolling friction |S| <= mu_r r R in contact
/// dynamics (Bratberg 2003, paper one, eq. (6)). Source of the elastic-plastic spring: Luding (2008); model C of Ai et
/// al. (2011) has the same spring, and a dashpot that acts below full mobilisation only (docs/physics/soft.md).
/// Validated by tests/unit/impact_test.cpp (decay of rolling, rest on a slope), tests/unit/rolling_test.cpp (the
/// dashpot) and tests/contract/laws_contract_test.cpp (limit).
struct RollingSpring {
  double friction = 0.1;   ///< mu_r >= 0
  double stiffness = 0.0;  ///< [M/T^2] force per rolled length, > 0
  double damping = 0.3;    ///< fraction of the critical damping of one rolling grain, >= 0

  static constexpr std::string_view name = "spring";
};

inline void parameters(RollingSpring& law, Parameters& to, const LawScales& scales) {
  to.number("friction", law.friction, required, not_negative, "", "mu_r: the torque is at most mu_r R N");
  to.number("stiffness", law.stiffness, {100.0 * scales.weight / scales.diameter, "100 m g/d"}, positive, "M/T^2",
            "torque over R per rolled length");
  to.number("damping", law.damping, 0.3, not_negative, "", "fraction of critical damping");
}

/// The effective stiffness [M/T^2] for the time step: k_r m R^2 / I for each of two grains, which may both rotate; for
/// discs 4 k_r.
inline double surface_stiffness(const RollingSpring& law, double, double, const Inertia& inertia) {
  return 2.0 * inertia.inverse * law.stiffness;
}

/// The torque divided by the roll radius [M L/T^2]. Advances the rolling displacement `roll` [L] by dt at the roll
/// velocity [L/T].
template <class T, class Tangential>
REPOSE_FN Tangential rolling_force(const RollingSpring& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                   const Tangential& roll_velocity, const std::type_identity_t<T>& dt,
                                   Tangential& roll) {
  constexpr double inertia = 1.0 / inertia_of<dimension_of_tangent<Tangential>>.inverse;
  const T dashpot = (2.0 * law.damping * root(inertia * law.stiffness)) * root(touch.mass);
  return slider_force(T(law.stiffness), T(1.0 / law.stiffness), dashpot, law.friction * positive_part(normal.total),
                      roll_velocity, dt, roll);
}

template <class Tangential>
double stored_energy(const RollingSpring& law, const Touch<double>&, const NormalForce<double>&,
                     const Tangential& roll) {
  return 0.5 * law.stiffness * squared(roll);
}

}  // namespace repose
