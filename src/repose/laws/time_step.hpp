// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/registry.hpp"

namespace repose {

/// The criterion for a time step: the stiffest contact that a fall from the source can cause.
struct StiffestContact {
  double frequency = 0.0;  ///< [1/T] w = sqrt(k / m), k at the overlap that the fall reaches, m of the moving grain
};

/// The size of a grain.
struct GrainSize {
  double diameter = 1.0;  ///< [L]
  double mass = 1.0;      ///< [M]
  bool flat = false;      ///< a flat wall, which acts as a grain of this size except that it has no curvature
};

/// The stiffest contact between grains of these sizes, of which the first moves: discs in 2, spheres in 3 dimensions.
/// `fall` [L] is the greatest height of fall.
StiffestContact stiffest_contact(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner,
                                 double gravity, double fall, int dimension = 2);

/// The largest stable step [T] of a grain in a dense bed: the mover has six such partners in 2, twelve in 3 dimensions,
/// each pressed on it with `force` [M L/T^2]. The dashpots use the velocities of the previous half-step, so a mode with
/// stiffness K and dashpot C, both divided by its mass, is stable for K dt^2 + 2 C dt < 4.
///
/// The springs of a bed store at most twice what they store if every grain alone has its displacement, since
/// (a - b)^2 <= 2 a^2 + 2 b^2. So K is twice the sum over the neighbours of one grain, for three kinds of motion:
///
///     motion                                    discs               spheres
///     neighbours that move against each other   6 (k_n + k_t)/m     (8 k_n + 16 k_t)/m
///     grains that all spin in the same sense    24 k_t/m            (40 k_t + 20 k_w)/m
///     neighbours that spin against each other   24 k_r/m            (40 k_r + 20 k_w)/m
///
/// with the stiffness k_r of the resistance to rolling and k_w of that to twisting. Spheres that spin in the same sense
/// where they slip may still twist against each other where they do not. Of six discs in a plane the squares
/// of a component of n add up to 3, of the twelve of a close packing of spheres to 4, and those across it to 3 and 8; a
/// spin slips and rolls with all of a disc's six, with 8 of a sphere's twelve; R^2 m / I is 2 and 5/2. C likewise.
/// Motions that mix these kinds may have up to 1/9 more where k_r is near k_t. Infinity if the law cannot carry the
/// force. Validated by tests/unit/laws_test.cpp, tests/unit/rolling_test.cpp, tests/unit/time_step_of_spheres_test.cpp
/// (eigenvalues of a close packing; a bed of spheres below and above the limit), tests/cli/test_physics.py (beds of
/// discs below and above the limit).
double largest_step_of_bed(const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner, double force,
                           int dimension = 2);

/// What a piston moves against: its own spring and drag, and a number of grains.
struct PistonLoad {
  double count = 1.0;      ///< grains that touch it at once
  double force = 0.0;      ///< [M L/T^2] with which each is pressed on it
  double alignment = 1.0;  ///< cosine between its direction and the normal of its face
  double mass = 0.0;       ///< [M] of the piston; a dashpot set by restitution depends on it
  double stiffness = 0.0;  ///< [M/T^2] of its own spring
  double drag = 0.0;       ///< [M/T]
};

/// The least mass [M] with which the piston is stable in steps of `step` [T]. The stiffness K and the dashpot C of all
/// contacts along its motion add up, and K dt^2 + 2 C dt < 4 M as for a bed; a step counts as 1 / auto_part_of_bed
/// times as long. Rotation plays no part, so that it holds for discs and spheres.
/// Validated by tests/unit/laws_test.cpp, tests/cli/test_walls.py (pistons above and below the
/// limit).
double least_piston_mass(const ContactLaws& laws, const GrainSize& grain, const PistonLoad& load, double step);

/// A step above w dt = `largest_phase` is refused. "auto" takes the smaller of w dt = `auto_phase` and the fraction
/// `auto_part_of_bed` of the largest stable step of a bed.
inline constexpr double largest_phase = 1.0;
inline constexpr double auto_phase = 0.5;
inline constexpr double auto_part_of_bed = 0.7;

}  // namespace repose
