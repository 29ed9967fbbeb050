// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/laws/displacement.hpp"
#include "repose/laws/inertia.hpp"
#include "repose/laws/scales.hpp"
#include "repose/laws/tangential/limit.hpp"
#include "repose/laws/touch.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>

namespace repose {

/// A torque mu_r R N against the rolling, whatever its velocity v_r. Below the small velocity `full_at` the torque is
/// proportional to v_r, since one that only changes its sign at rest would shake grains. So a contact at rest carries
/// no torque: grains creep at up to `full_at` where a spring would hold them. A disc that rolls on a plane slows down
/// by 2/3 mu_r g, a sphere by 5/7 mu_r g. Source: model A of Ai et al. (2011).
/// Validated by tests/unit/rolling_test.cpp (deceleration, creep).
struct RollingConstant {
  double friction = 0.1;  ///< mu_r >= 0
  double full_at = 0.01;  ///< [L/T] > 0

  static constexpr std::string_view name = "constant";
};

inline void parameters(RollingConstant& law, Parameters& to, const LawScales& scales) {
  to.number("friction", law.friction, required, not_negative, "", "mu_r: the torque is mu_r R N");
  to.number("full_at", law.full_at, {0.01 * std::sqrt(scales.gravity * scales.diameter), "0.01 sqrt(g d)"}, positive,
            "L/T", "rolling velocity above which the torque is complete; it grows linearly up to there");
}

/// None: the slope of the torque is that of a dashpot, which the step of a dense bed takes into account.
inline double surface_stiffness(const RollingConstant&, double, double, const Inertia&) { return 0.0; }

template <class T, class Tangential>
REPOSE_FN Tangential rolling_force(const RollingConstant& law, const Touch<T>&, const NormalForce<T>& normal,
                                   const Tangential& roll_velocity, const std::type_identity_t<T>&, Tangential&) {
  const T limit = law.friction * positive_part(normal.total);
  return limited(roll_velocity * (-limit / law.full_at), limit);
}

template <class T, class Tangential>
REPOSE_FN Tangential displaced(const RollingConstant&, const Touch<T>&, const Tangential&, double,
                               const Tangential& unmoved) {
  return unmoved;
}

template <class Tangential>
double stored_energy(const RollingConstant&, const Touch<double>&, const NormalForce<double>&, const Tangential&) {
  return 0.0;
}

}  // namespace repose
