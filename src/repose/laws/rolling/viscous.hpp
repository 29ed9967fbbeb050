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

#include <string_view>

namespace repose {

/// Resistance proportional to the rolling velocity: the torque over R is -b m_red v_r, at most mu_r N. It carries no
/// torque at rest, so a disc rolls down any slope. A disc on a plane, which rolls without sliding, slows down as
/// exp(-2/3 b t), a sphere as exp(-5/7 b t). Source: model B of Ai et al. (2011). Validated by
/// tests/unit/rolling_test.cpp (decay, limit).
struct RollingViscous {
  double friction = 0.1;  ///< mu_r >= 0
  double rate = 1.0;      ///< [1/T] b > 0

  static constexpr std::string_view name = "viscous";
};

inline void parameters(RollingViscous& law, Parameters& to, const LawScales&) {
  to.number("friction", law.friction, required, not_negative, "", "mu_r: the torque is at most mu_r R N");
  to.number("rate", law.rate, required, positive, "1/T", "torque over R, reduced mass and rolling velocity");
}

/// The stiffness [M/T^2], for the time step, of a spring as fast as the dashpot: the spin decays at the rate b m R^2 /
/// I, that of a disc at 2 b.
inline double surface_stiffness(const RollingViscous& law, double /*normal_stiffness*/, double mass,
                                const Inertia& inertia) {
  return mass * (inertia.inverse * inertia.inverse) * law.rate * law.rate;
}

template <class T, class Tangential>
REPOSE_FN Tangential rolling_force(const RollingViscous& law, const Touch<T>& touch, const NormalForce<T>& normal,
                                   const Tangential& roll_velocity, double, Tangential&) {
  return limited(roll_velocity * (-law.rate * touch.reduced_mass()), law.friction * positive_part(normal.total));
}

template <class T, class Tangential>
REPOSE_FN Tangential displaced(const RollingViscous&, const Touch<T>&, const Tangential&, double,
                               const Tangential& unmoved) {
  return unmoved;
}

template <class Tangential>
double stored_energy(const RollingViscous&, const Touch<double>&, const NormalForce<double>&, const Tangential&) {
  return 0.0;
}

}  // namespace repose
