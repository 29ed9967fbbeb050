// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

namespace repose {

/// What a time step is judged by: the stiffest contact that a fall from the source can bring about.
struct StiffestContact {
  double frequency = 0.0;  ///< [1/T] w = sqrt(k / m), k at the overlap reached from the fall, m of the moving grain
};

/// A size of grains.
struct GrainSize {
  double diameter = 1.0;  ///< [L]
  double mass = 1.0;      ///< [M]
};

/// The stiffest contact of grains of these sizes, of which the first moves; `fall` [L] is the height of the highest
/// fall.
StiffestContact stiffest_contact(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner,
                                 double gravity, double fall);

/// The largest stable step [T] of a grain in a dense bed: the mover held by six such partners, each pressed on with
/// `force` [M L/T^2]. With velocities of the half-step before in the dashpots, a mode of stiffness K and dashpot C over
/// its mass is stable for K dt^2 + 2 C dt < 4. Two modes are looked at: neighbours that go against each other,
/// K = 6 (k_n + k_t) / m, and discs that all spin the same way, K = 24 k_t / m (lever R, inertia m R^2 / 2, both discs
/// of a contact); C likewise. Infinity if the law cannot carry the force.
/// Validated by tests/unit/laws_test.cpp, tests/cli/test_physics.py (beds below and above the limit).
double largest_step_of_bed(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner, double force);

/// The step is refused beyond w dt = 1. "auto" takes half of that, or this part of the largest stable step of a bed,
/// whichever is less.
inline constexpr double largest_phase = 1.0;
inline constexpr double auto_phase = 0.5;
inline constexpr double auto_part_of_bed = 0.7;

}  // namespace repose
