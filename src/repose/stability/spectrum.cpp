// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/stability/spectrum.hpp"

#include "repose/core/eigen.hpp"
#include "repose/core/errors.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Dense = Eigen::VectorXd;

/// Bisection ends when the bounds are this close [largest entry of the diagonal].
constexpr double bound_width = 1e-9;
/// So does inverse iteration with a residual this small, or after so many solves.
constexpr double smallest_residual = 1e-12;
constexpr int most_solves = 100;
/// Where a pivot is zero, x is moved by this [largest entry of the diagonal].
constexpr double nudge = 1e-13;
constexpr int most_nudges = 8;

Sparse sparse(const SymmetricMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(matrix.lower.size() + matrix.size);
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (const auto& one : matrix.lower) add(one.row, one.column, one.value);
  for (std::size_t k = 0; k < matrix.size; ++k) add(k, k, 0.0);  // the diagonal has an entry in every row
  const auto size = static_cast<int>(matrix.size);
  Sparse made(size, size);
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

/// No eigenvalue is smaller (Gershgorin).
double lower_bound(const Sparse& lower) {
  Dense off = Dense::Zero(lower.rows());
  for (int column = 0; column < lower.outerSize(); ++column) {
    for (Sparse::InnerIterator entry(lower, column); entry; ++entry) {
      if (entry.row() == entry.col()) continue;
      off[entry.row()] += std::fabs(entry.value());
      off[entry.col()] += std::fabs(entry.value());
    }
  }
  return (lower.diagonal() - off).minCoeff();
}

}  // namespace

struct Spectrum::Matrix {
  Sparse lower;
  double scale = 0.0;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factors;

  /// Factors the matrix less x.
  void factorise(double x) {
    for (int attempt = 0; attempt < most_nudges; ++attempt) {
      factors.setShift(-x - attempt * nudge * scale);
      factors.factorize(lower);
      if (factors.info() == Eigen::Success) return;
    }
    throw RunError("the stiffness matrix cannot be factored: its pivots vanish");
  }
};

Spectrum::Spectrum(const SymmetricMatrix& matrix) : matrix_(std::make_unique<Matrix>()) {
  REPOSE_ASSERT(matrix.size > 0);
  matrix_->lower = sparse(matrix);
  matrix_->scale = matrix_->lower.diagonal().cwiseAbs().maxCoeff();
  matrix_->factors.analyzePattern(matrix_->lower);
}

Spectrum::~Spectrum() = default;

std::size_t Spectrum::below(double x) {
  matrix_->factorise(x);
  return static_cast<std::size_t>((matrix_->factors.vectorD().array() < 0.0).count());
}

Spectrum::Smallest Spectrum::smallest() {
  auto& matrix = *matrix_;
  const double width = bound_width * matrix.scale;
  // An eigenvalue is no larger than any entry of the diagonal.
  double low = lower_bound(matrix.lower) - width;
  double high = matrix.lower.diagonal().minCoeff() + width;
  while (high - low > width) {
    const double middle = 0.5 * (low + high);
    (below(middle) > 0 ? high : low) = middle;
  }
  matrix.factorise(low - width);
  const auto full = matrix.lower.selfadjointView<Eigen::Lower>();
  Dense vector(matrix.lower.rows());
  // Any vector that is not orthogonal to the one that is sought; this one has no symmetry of a pile.
  constexpr double golden = 0.6180339887498949;
  for (int k = 0; k < vector.size(); ++k) vector[k] = std::fmod(golden * (k + 1), 1.0) - 0.45;
  vector.normalize();
  Smallest found;
  for (int solve = 0; solve < most_solves; ++solve) {
    vector = matrix.factors.solve(vector).normalized();
    const Dense product = full * vector;
    found.value = vector.dot(product);
    found.residual = (product - found.value * vector).norm();
    if (found.residual <= smallest_residual * matrix.scale) break;
  }
  Eigen::Index largest = 0;
  vector.cwiseAbs().maxCoeff(&largest);
  if (vector[largest] < 0.0) vector = -vector;
  found.vector.assign(vector.data(), vector.data() + vector.size());
  return found;
}

}  // namespace repose
