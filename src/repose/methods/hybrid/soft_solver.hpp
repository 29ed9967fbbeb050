// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/hybrid/soft_system.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace repose::hybrid {

/// What a solution took.
struct Solved {
  bool converged = false;
  long iterations = 0;  ///< of Newton's method, or sweeps
  double residual = 0.0;
  std::uint32_t worst = nobody;  ///< body with the largest residual
};

/// Newton's method on all bodies at once, with a sparse Cholesky factorisation (LDL^T) of the symmetric part of its
/// matrix. The order of elimination is kept while the same bodies are near each other.
class DirectSolver {
 public:
  DirectSolver();
  ~DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;
  DirectSolver& operator=(DirectSolver&&) noexcept;

  /// Solves to a residual of `tolerance` [weight], from the displacements that the bodies have. Without `definite`, the
  /// matrix may have negative directions; with it, a matrix that has is replaced by that of straight forces.
  Solved solve(SoftSystem& system, double tolerance, bool definite = false);

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

/// The same by block Gauss-Seidel, body by body, with relaxation: slow, and simple enough to be a reference.
/// Source: Liffman, Chan and Hughes (1992), "Experimental".
Solved solve_by_sweeps(SoftSystem& system, double tolerance, double relaxation);

}  // namespace repose::hybrid
