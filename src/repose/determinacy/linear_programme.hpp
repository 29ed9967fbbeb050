// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace repose {

/// Least and largest values of linear functions of unknowns x that obey lower <= A x <= upper and are each within
/// bounds of their own. Each search starts where the last one ended. By the simplex method of CLP.
class LinearProgramme {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Entry {
    std::size_t row = 0;
    double value = 0.0;
  };
  /// An unknown: its coefficients and its bounds.
  struct Column {
    std::vector<Entry> entries;
    double lower = 0.0;
    double upper = infinity;
  };
  struct Row {
    double lower = -infinity;
    double upper = infinity;
  };

  /// `failed`: the method gave up on rounding.
  enum class End { found, unbounded, infeasible, failed };
  struct Optimum {
    End end = End::failed;
    double value = 0.0;
    std::vector<double> x;
  };

  LinearProgramme(const std::vector<Column>& columns, const std::vector<Row>& rows);
  ~LinearProgramme();
  LinearProgramme(const LinearProgramme&) = delete;
  LinearProgramme& operator=(const LinearProgramme&) = delete;

  /// `cost` has a number for each unknown.
  Optimum least(const std::vector<double>& cost);
  Optimum most(const std::vector<double>& cost);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace repose
