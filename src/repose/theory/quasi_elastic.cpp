// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/quasi_elastic.hpp"

namespace repose::theory {

double stress_ratio(const QuasiElastic& matter) { return matter.poisson_ratio / (1.0 - matter.poisson_ratio) + 0.0; }

void parameters(QuasiElastic& matter, Parameters& to) {
  to.number("poisson_ratio", matter.poisson_ratio, {.low = -1.0, .high = 0.5, .low_allowed = false}, "1",
            "Poisson's ratio of the bulk, nu");
}

Table evaluate(const QuasiElastic& matter) {
  return {{{"poisson_ratio", "1", "Poisson's ratio of the bulk, nu", {matter.poisson_ratio + 0.0}, {}},
           {"stress_ratio", "1", "horizontal over vertical stress, K", {stress_ratio(matter)}, {}}},
          {}};
}

}  // namespace repose::theory
