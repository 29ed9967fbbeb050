// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <vector>

namespace repose::contact_dynamics {

struct SolverSettings {
  double tolerance = 1e-8;    ///< of Residual::worst
  long most_sweeps = 20000;   ///< forward and backward sweeps at most
  bool accelerated = true;    ///< conjugate gradients; else sweeps alone
};

/// What a solution cost and how good it is.
struct Solution {
  long sweeps = 0;        ///< forward and backward, each pair counted once
  double residual = 0.0;  ///< Residual::worst of the impulses that were left
  bool converged = true;  ///< residual within the tolerance
};

/// Solves the contact problem by symmetric sweeps of nonlinear Gauss-Seidel from the impulses that the contacts bring,
/// made faster by nonlinear conjugate gradients. Leaves impulses, and bodies whose velocities are made of them.
/// Source: Moreau (1988), Jean (1999) for the sweeps; Silcowitz, Niebe & Erleben (2010) for the acceleration.
template <int D>
class Solver {
 public:
  explicit Solver(const SolverSettings& settings) : settings_(settings) {}

  Solution solve(Problem<D>& problem);

 private:
  void begin(const Problem<D>& problem);
  /// Largest change of velocity [L/T] that the last sweeps brought at a contact, over its mass.
  double measure(const Problem<D>& problem);
  void extrapolate(Problem<D>& problem);

  SolverSettings settings_;
  std::vector<Impulse<D>> before_;      // impulses before the last sweeps
  std::vector<Impulse<D>> direction_;   // of the conjugate gradients
  std::vector<Body<D>> bodies_before_;  // the same for velocities
  std::vector<Body<D>> bodies_direction_;
  std::vector<Body<D>> scratch_;
  double squared_change_ = 0.0;
  double previous_squared_change_ = 0.0;
};

}  // namespace repose::contact_dynamics
