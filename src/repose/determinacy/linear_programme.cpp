// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/linear_programme.hpp"

#include "repose/core/errors.hpp"

#include <coin/Clp_C_Interface.h>

namespace repose {

namespace {

/// By which unknowns may miss their bounds, and reduced costs zero, at an optimum. Forces are of the order of 1.
constexpr double tolerance = 1e-9;

LinearProgramme::End end_of(Clp_Simplex* model) {
  switch (Clp_status(model)) {
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
  Clp_Simplex* clp = Clp_newModel();
  Model() = default;
  ~Model() { Clp_deleteModel(clp); }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
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
  Clp_setLogLevel(model_->clp, 0);
  Clp_loadProblem(model_->clp, static_cast<int>(columns.size()), static_cast<int>(rows.size()), start.data(),
                  index.data(), value.data(), column_lower.data(), column_upper.data(), no_cost.data(),
                  row_lower.data(), row_upper.data());
  Clp_setPrimalTolerance(model_->clp, tolerance);
  Clp_setDualTolerance(model_->clp, tolerance);
}

LinearProgramme::~LinearProgramme() = default;

LinearProgramme::Optimum LinearProgramme::least(const std::vector<double>& cost) {
  auto* clp = model_->clp;
  REPOSE_ASSERT(cost.size() == static_cast<std::size_t>(Clp_numberColumns(clp)));
  Clp_chgObjCoefficients(clp, cost.data());
  // Without a cost every feasible point is an optimum, which the dual method finds soonest.
  if (!begun_) {
    const std::vector<double> no_cost(cost.size(), 0.0);
    Clp_chgObjCoefficients(clp, no_cost.data());
    Clp_dual(clp, 0);
    Clp_chgObjCoefficients(clp, cost.data());
    begun_ = true;
  }
  Clp_primal(clp, 0);
  Optimum optimum;
  optimum.end = end_of(clp);
  if (optimum.end != End::found) return optimum;
  optimum.value = Clp_objectiveValue(clp);
  const double* x = Clp_getColSolution(clp);
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
