// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace repose {

/// The work and accuracy of an implicit method's solver over a number of steps. An unconverged step is no error by
/// itself, but it is counted: an unconverged packing creeps, and the creep looks like rearrangement.
struct SolverAccount {
  std::int64_t steps = 0;
  std::int64_t sweeps = 0;              ///< a sweep visits all contacts forward and backward
  std::int64_t contact_iterations = 0;  ///< visits of contacts; forward and backward count as two
  std::int64_t unconverged = 0;         ///< steps that reached the limit on sweeps
  double worst_residual = 0.0;          ///< [gravity times time step] the largest of all steps
  std::int64_t impacts = 0;             ///< impacts of contacts with restitution
  std::int64_t reduced = 0;             ///< impacts whose restitution gave way, so that energy does not rise
  double restitution_lost = 0.0;        ///< sum over impacts of the fraction of restitution that gave way

  SolverAccount& operator+=(const SolverAccount& b) {
    steps += b.steps;
    sweeps += b.sweeps;
    contact_iterations += b.contact_iterations;
    unconverged += b.unconverged;
    impacts += b.impacts;
    reduced += b.reduced;
    restitution_lost += b.restitution_lost;
    worst_residual = std::max(worst_residual, b.worst_residual);
    return *this;
  }
};

}  // namespace repose
