// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/any_law.hpp"

namespace repose {

/// Two grains that meet, or a grain and what cannot move.
struct ImpactConditions {
  double mass = 1.0;          ///< [M] m_ij of the nominal masses
  double reduced_mass = 0.5;  ///< [M] that truly moves
  double diameter = 1.0;      ///< [L] mean of the two
  double speed = 1.0;         ///< [L/T] at which they meet
};

/// What comes of it.
struct Impact {
  double restitution = 0.0;  ///< speed after over speed before
  double duration = 0.0;     ///< [T] for which they overlap
  double overlap = 0.0;      ///< [L] the largest
  double force = 0.0;        ///< [M L/T^2] the largest
};

/// A single head-on impact without gravity, followed from the edge of the law's reach back to it, to about 1e-5.
Impact head_on(const AnyNormal& law, const ImpactConditions& conditions);

/// The law with the damping that gives the restitution asked for; as it is if none is. Restitution is set for equal
/// grains that are both free; where it depends on the law's damping alone (Hooke, Hertz) it then holds for all others
/// too. Not a number if no damping up to 20 times the critical one does.
NormalLaw with_restitution(const NormalLaw& law, double mass, double diameter);

/// Overlap [L] at which the law carries a force at rest; a law that acts from afar may carry it without any (<= 0).
double static_overlap(const AnyNormal& law, double mass, double diameter, double force);

}  // namespace repose
