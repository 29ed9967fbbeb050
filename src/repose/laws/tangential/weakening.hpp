// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/slider.hpp"
#include "repose/laws/touch.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace repose {

/// The linear spring and dashpot with friction that falls with the speed v of slip, from the static to the dynamic
/// coefficient: mu(v) = mu_d + (mu_s - mu_d) max(0, 1 - v/v_0), the law that contact dynamics has for rigid grains
/// (laws/impulse_law.hpp). v is the whole tangential velocity: a contact that holds while its load grows creeps by the
/// stretching of its spring, and v_0 should be well above that speed. Validated by tests/unit/laws_test.cpp and
/// tests/cli/test_slips.py (one grain on a spring).
struct Weakening {
  double friction = 0.5;            ///< mu_s >= 0
  double stiffness = 100;           ///< [M/T^2] > 0
  double damping = 0.0;             ///< fraction of the critical damping of one grain's translation, >= 0
  double dynamic_friction = 0.2;    ///< mu_d >= 0
  double weakening_velocity = 0.1;  ///< [L/T] v_0 > 0

  static constexpr std::string_view name = "weakening";

  template <class T>
  REPOSE_FN T friction_at(const T& slip_speed) const {
    const T left = positive_part(1.0 - slip_speed / weakening_velocity);
    return dynamic_friction + (friction - dynamic_friction) * left;
  }
};

inline void parameters(Weakening& law, Parameters& to, const LawScales& scales) {
  law.friction = scales.friction;
  to.number("stiffness", law.stiffness, required, positive, "M/T^2", "spring constant k_t");
  to.number("damping", law.damping, 0.0, not_negative, "", "fraction of critical damping");
  to.number("dynamic_friction", law.dynamic_friction, required, not_negative, "",
            "friction of contacts that slide at weakening_velocity or faster");
  to.number("weakening_velocity", law.weakening_velocity, required, positive, "L/T",
            "slip at which friction has fallen to dynamic_friction, linearly");
}

/// As of the linear law.
inline double surface_stiffness(const Weakening& law, double /*normal_stiffness*/, double /*mass*/,
                                const Inertia& inertia) {
  return inertia.at_rim() * law.stiffness;
}

template <class T, class Tangential>
REPOSE_FN Tangential tangential_force(const Weakening& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                      const Tangential& slip_velocity, const std::type_identity_t<T>& dt,
                                      Tangential& slip) {
  const T dashpot = (2.0 * law.damping * root(law.stiffness)) * root(touch.mass);
  return slider_force(T(law.stiffness), T(1.0 / law.stiffness), dashpot, coulomb_limit(law, normal, slip_velocity),
                      slip_velocity, dt, slip);
}

/// At rest.
template <class T>
REPOSE_FN T coulomb_limit(const Weakening& law, const NormalForce<T>& normal) {
  return law.friction * positive_part(normal.total);
}

/// At this slip.
template <class T, class Tangential>
REPOSE_FN T coulomb_limit(const Weakening& law, const NormalForce<T>& normal, const Tangential& slip_velocity) {
  return law.friction_at(magnitude(slip_velocity)) * positive_part(normal.total);
}

template <class Tangential>
double stored_energy(const Weakening& law, const Touch<double>&, const NormalForce<double>&, const Tangential& slip) {
  return 0.5 * law.stiffness * squared(slip);
}

}  // namespace repose
