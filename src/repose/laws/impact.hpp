// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"

namespace repose {

/// A head-on impact of two grains, or of a grain on a fixed grain or wall.
struct ImpactConditions {
  double mass = 1.0;          ///< [M] 2 m_i m_j / (m_i + m_j) of the nominal masses
  double reduced_mass = 0.5;  ///< [M] m_i m_j / (m_i + m_j) with an infinite mass for a fixed partner
  double diameter = 1.0;      ///< [L] mean of the two diameters
  double speed = 1.0;         ///< [L/T] closing speed before
};

/// The result of an impact.
struct Impact {
  double restitution = 0.0;  ///< speed after divided by speed before
  double duration = 0.0;     ///< [T] time of overlap
  double overlap = 0.0;      ///< [L] largest overlap
  double force = 0.0;        ///< [M L/T^2] largest force
};

/// Integrates a single head-on impact without gravity until the pair leaves the reach of the law; accurate to about
/// 1e-5.
Impact head_on(const AnyNormal& law, const ImpactConditions& conditions);

/// The law with the damping that gives its requested restitution; unchanged if it requests none. The damping is found
/// for two free grains of this mass and diameter. Where restitution depends on the damping alone (Hooke, Hertz), it
/// then holds for all other grains too. The damping is not a number if none up to 20 times critical gives the
/// restitution.
NormalLaw with_restitution(const NormalLaw& law, double mass, double diameter);

/// The overlap [L] at which the law carries `force` [M L/T^2] at rest. A law that acts beyond touching may carry it at
/// an overlap <= 0. Infinity if it cannot carry the force.
double static_overlap(const AnyNormal& law, double mass, double diameter, double force);

}  // namespace repose
