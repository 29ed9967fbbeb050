// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"

#include <cstdint>
#include <vector>

namespace repose::contact_dynamics {

/// A contact that rebounds: Newton's restitution asks for these biases of its formal velocities.
template <int D>
struct Rebound {
  std::uint32_t contact = 0;  ///< its place among the contacts of the problem
  double normal_bias = 0.0;   ///< [L/T] restitution times the normal velocity before, <= 0
  Tangent<D> tangent_bias{};  ///< [L/T] tangential restitution times the slip velocity before
};

/// What became of the impacts of one step.
struct ImpactReport {
  long impacts = 0;               ///< contacts that asked for restitution
  long reduced = 0;               ///< those of them whose restitution gave way
  double restitution_lost = 0.0;  ///< sum of the fractions by which it gave way
  long contact_sweeps = 0;        ///< contacts times sweeps
  Solution solution;              ///< the sweeps of all solutions, the worst residual
};

/// Solves an impact. `problem.free` holds the velocities just before it; the biases of the contacts are those without
/// restitution and not negative, so that impulses without restitution exist. Sets impulses and velocities.
///
/// The kinetic energy of a cluster of contacts does not rise. Newton's restitution with friction can ask for a rise,
/// or for velocities that no impulses give (Kane and Levinson 1985). There restitution gives way: around the contacts
/// that supply energy or violate the law, and if that is not enough in the whole cluster. The impulses are then the
/// combination of those with and without that restitution, with the most restitution that creates no energy. Both
/// obey Coulomb's law and do not penetrate, and so does their combination. Source: docs/physics/contact_dynamics.md.
template <int D>
ImpactReport solve_impact(const std::vector<Rebound<D>>& rebounds, Solver<D>& solver, Problem<D>& problem);

/// Whether impulses have grown without bound, because none satisfy the laws.
template <int D>
bool ran_away(const Problem<D>& problem);

/// Whether the kinetic energy of all bodies is higher than with the free velocities.
template <int D>
bool gains_energy(const Problem<D>& problem);

/// Makes the impulses of clusters smaller in which the kinetic energy is higher than that of the free velocities, less
/// the work of moving walls. Impulses without restitution never raise it but by the tolerance of the solver. Sets the
/// velocities.
template <int D>
void take_back_gains(Problem<D>& problem);

}  // namespace repose::contact_dynamics
