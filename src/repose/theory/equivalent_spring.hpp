// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// The linear spring that does the same work as the continuous interaction m g (d/r)^(n+1) from its cutoff to a closest
/// approach. Source: Baxter et al. (1997), (14) with its limits in the right order. Forces in m g, lengths in d.
/// Validated by tests/theory/equivalent_spring_test.cpp.
struct EquivalentSpring {
  double exponent = 36.0;  ///< n
  double cutoff = 1.2;     ///< r0 [d]
  double closest = 0.915;  ///< r_i [d]
  std::int64_t points = 201;

  static constexpr ModelText text{.name = "equivalent-spring",
                                  .about = "Linear spring that does the work of the continuous interaction",
                                  .source = "Baxter et al. 1997, eq. (14) and Fig. 4, corrected"};
};

/// 2 W/(1 - r_i)^2 [m g/d], W the work of the continuous interaction from r0 to r_i.
double equivalent_stiffness(const EquivalentSpring& contact);

void parameters(EquivalentSpring& contact, Parameters& to);

/// Both forces over the distance from r_i to r0, and the numbers stiffness and work.
Table evaluate(const EquivalentSpring& contact);

}  // namespace repose::theory
