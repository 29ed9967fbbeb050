// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace repose {

/// What an implicit method's solver did over some steps. Steps that are not converged are no error by themselves, but
/// they are counted: an unconverged packing creeps, and the creep looks like rearrangement.
struct SolverAccount {
  std::int64_t steps = 0;
  std::int64_t sweeps = 0;              ///< forward and backward
  std::int64_t contact_iterations = 0;  ///< contacts visited by sweeps, each way counted
  std::int64_t unconverged = 0;         ///< steps that reached the cap
  double worst_residual = 0.0;          ///< [gravity times time step] of all steps

  SolverAccount& operator+=(const SolverAccount& b) {
    steps += b.steps;
    sweeps += b.sweeps;
    contact_iterations += b.contact_iterations;
    unconverged += b.unconverged;
    worst_residual = std::max(worst_residual, b.worst_residual);
    return *this;
  }
};

}  // namespace repose
