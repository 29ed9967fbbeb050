// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/contact_problem/contact_problem.hpp"
#include "repose/methods/contact_dynamics/residual.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"

#include <string>

namespace repose {

/// What the solver made of a contact problem and what that took.
struct ContactSolution {
  contact_dynamics::SolverSettings settings;
  bool warm = false;  ///< from the impulses of the file, else from none
  contact_dynamics::Solution solution;
  contact_dynamics::Residual residual;
  double cpu_seconds = 0.0;  ///< of the solver alone

  /// Contacts visited by sweeps, each way counted.
  static double contact_iterations(const ContactProblem& posed, const contact_dynamics::Solution& solution) {
    return 2.0 * static_cast<double>(solution.sweeps) * static_cast<double>(posed.problem.contacts.size());
  }
};

/// Leaves the impulses, and the velocities that they make, in the problem.
ContactSolution solve(ContactProblem& posed, const contact_dynamics::SolverSettings& settings, bool warm);

/// Throws RunError.
void write_contact_solution(const std::string& path, const ContactProblem& solved, const ContactSolution& solution);

}  // namespace repose
