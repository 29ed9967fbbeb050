// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/linear_programme.hpp"

#include "repose/core/errors.hpp"

#include <coin/ClpSimplex.hpp>

namespace repose {

namespace {

/// By which unknowns may miss their bounds, and reduced costs zero, at an optimum. Forces are of the order of 1.
constexpr double tolerance = 1e-9;

/// Data and factorisation of one search stay for the next: a third of the time.
constexpr int keep_all = 1 + 2;

LinearProgramme::End end_of(const ClpSimplex& clp) {
  switch (clp.status()) {
    case 0:
      return LinearProgramme::End::found;
    case 1:
      return LinearProgramme::End::infeasible;
    case 2:
      return LinearProgramme::End::unbounded;
    default:
      return LinearProgramme::End::failed;
  }
}

}  // namespace

struct LinearProgramme::Model {
  ClpSimplex clp;
};

LinearProgramme::LinearProgramme(const std::vector<Column>& columns, const std::vector<Row>& rows)
    : model_(std::make_unique<Model>()) {
  std::vector<CoinBigIndex> start{0};
  std::vector<int> index;
  std::vector<double> value, column_lower, column_upper, row_lower, row_upper;
  for (const auto& column : columns) {
    for (const auto& entry : column.entries) {
      REPOSE_ASSERT(entry.row < rows.size());
      index.push_back(static_cast<int>(entry.row));
      value.push_back(entry.value);
    }
    start.push_back(static_cast<CoinBigIndex>(index.size()));
    column_lower.push_back(column.lower);
    column_upper.push_back(column.upper);
  }
  for (const auto& row : rows) {
    row_lower.push_back(row.lower);
    row_upper.push_back(row.upper);
  }
  const std::vector<double> no_cost(columns.size(), 0.0);
  auto& clp = model_->clp;
  clp.setLogLevel(0);
  clp.loadProblem(static_cast<int>(columns.size()), static_cast<int>(rows.size()), start.data(), index.data(),
                  value.data(), column_lower.data(), column_upper.data(), no_cost.data(), row_lower.data(),
                  row_upper.data());
  clp.setPrimalTolerance(tolerance);
  clp.setDualTolerance(tolerance);
  // Without a cost every state within the bounds is extreme, and the dual method finds one soonest.
  clp.dual();
}

LinearProgramme::~LinearProgramme() = default;

LinearProgramme::Optimum LinearProgramme::least(const std::vector<double>& cost) {
  auto& clp = model_->clp;
  REPOSE_ASSERT(cost.size() == static_cast<std::size_t>(clp.numberColumns()));
  clp.chgObjCoefficients(cost.data());
  clp.primal(0, keep_all);
  Optimum optimum;
  optimum.end = end_of(clp);
  if (optimum.end != End::found) return optimum;
  optimum.value = clp.objectiveValue();
  const double* x = clp.getColSolution();
  optimum.x.assign(x, x + cost.size());
  return optimum;
}

LinearProgramme::Optimum LinearProgramme::most(const std::vector<double>& cost) {
  auto opposite = cost;
  for (double& value : opposite) value = -value;
  auto optimum = least(opposite);
  optimum.value = -optimum.value;
  return optimum;
}

}  // namespace repose
