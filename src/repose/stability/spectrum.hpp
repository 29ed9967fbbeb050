// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/stability/stiffness_matrix.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace repose {

/// The lower end of the spectrum of a sparse symmetric matrix. By Sylvester's law of inertia, a matrix less x on its
/// diagonal has as many negative pivots as there are eigenvalues below x; the pivots are those of Eigen's sparse
/// L D L^T. Validated by tests/unit/stability_test.cpp.
class Spectrum {
 public:
  /// The matrix has at least one row.
  explicit Spectrum(const SymmetricMatrix& matrix);
  ~Spectrum();
  Spectrum(const Spectrum&) = delete;
  Spectrum& operator=(const Spectrum&) = delete;

  /// The number of eigenvalues below x.
  std::size_t below(double x);

  struct Smallest {
    double value = 0.0;
    std::vector<double> vector;  ///< of length 1; its largest entry is positive
    double residual = 0.0;       ///< length of K v - value v
  };
  /// The smallest eigenvalue: between bounds that bisection narrows, then by inverse iteration from below them. Of
  /// several equal ones, the vector is any of their space.
  Smallest smallest();

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

}  // namespace repose
