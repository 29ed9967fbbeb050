// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose::theory {

/// A stack of cells between two walls. Each cell has one grain in the middle below two grains that touch the walls, so
/// this is a Janssen column whose walls act at discrete heights. Grains do not rotate.
/// Source: Bratberg's thesis (2003), eqs (30)-(40), corrected. Validated by tests/theory/janssen_discrete_test.cpp.
struct JanssenDiscrete {
  double k_mu = 0.1;                ///< K mu; below 1/2 if pushed up
  std::int64_t layers = 20;         ///< number of cells, N
  std::string direction = "rest";   ///< rest | pushed-up
  std::string wall_load = "below";  ///< below, N_i = K F_i of (31) | mean, K (F_(i-1) + F_i)/2 | above, K F_(i-1)

  static constexpr ModelText text{.name = "janssen-discrete",
                                  .about = "Force below a column of cells of three grains between two rough walls",
                                  .source = "Bratberg 2003 (thesis), eqs (30)-(40), corrected"};
};

/// The upward force on the middle grain of the lowest of `layers` cells, in weights of a grain.
double force_below(const JanssenDiscrete& stack, std::int64_t layers);

/// The lengths in force = 3 lambda_1 (1 - exp(-N/lambda_2)), or 3 lambda_1 (exp(N/lambda_2) - 1) if pushed up, in
/// heights of a cell; infinite at k_mu = 0.
struct DiscreteLengths {
  double lambda_1 = 0.0;
  double lambda_2 = 0.0;
  double ratio = 1.0;  ///< lambda_1/lambda_2; with the wall load of (31) above 1 if pushed up, below 1 at rest
};
DiscreteLengths discrete_lengths(const JanssenDiscrete& stack);

void parameters(JanssenDiscrete& stack, Parameters& to);
std::vector<std::string> relations(const JanssenDiscrete& stack);

/// A table with the columns layer (1 to N from the top) and force.
Table evaluate(const JanssenDiscrete& stack);

}  // namespace repose::theory
