// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

namespace repose::theory {

/// The ratio of horizontal to vertical stress in an elastic column whose walls prevent it from widening.
/// Source: Bratberg's thesis (2003), eq. (48), after Evesque and de Gennes (1998).
/// Validated by tests/theory/quasi_elastic_test.cpp.
struct QuasiElastic {
  double poisson_ratio = 0.3;  ///< of the bulk, in (-1, 1/2]

  static constexpr ModelText text{.name = "quasi-elastic",
                                  .about = "Stress ratio of an elastic column between rigid walls",
                                  .source = "Bratberg 2003 (thesis), eq. (48); Evesque and de Gennes 1998"};
};

/// K = nu/(1 - nu), from -1/2 to 1; negative if the walls would have to pull.
double stress_ratio(const QuasiElastic& matter);

void parameters(QuasiElastic& matter, Parameters& to);

/// A table of one row with the columns poisson_ratio and stress_ratio.
Table evaluate(const QuasiElastic& matter);

}  // namespace repose::theory
