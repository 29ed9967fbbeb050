// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

namespace repose::theory {

/// Ratio of horizontal to vertical stress in an elastic column that its walls keep from widening.
/// Source: Bratberg's thesis (2003), eq. (48), after Evesque and de Gennes (1998).
/// Validated by tests/theory/quasi_elastic_test.cpp.
struct QuasiElastic {
  double poisson_ratio = 0.3;  ///< of the matter as a whole, in (-1, 1/2]

  static constexpr ModelText text{.name = "quasi-elastic",
                                  .about = "Stress ratio of an elastic column between rigid walls",
                                  .source = "Bratberg 2003 (thesis), eq. (48); Evesque and de Gennes 1998"};
};

/// K = nu/(1 - nu): -1/2 to 1; negative where the walls would have to pull.
double stress_ratio(const QuasiElastic& matter);

void parameters(QuasiElastic& matter, Parameters& to);

/// Columns poisson_ratio, stress_ratio: one row.
Table evaluate(const QuasiElastic& matter);

}  // namespace repose::theory
