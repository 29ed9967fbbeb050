// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <limits>
#include <string>

namespace repose::theory {

/// Janssen's law with one or two lengths, fitted to the apparent masses of columns. They come from a table with the
/// columns height [L], apparent_mass [M] and optionally apparent_mass_error (or error, sigma) [M], in any order; other
/// columns are ignored and named. Source: Bratberg's thesis (2003), eqs (25) and (38), corrected. Validated by
/// tests/theory/screening_fit_test.cpp.
struct JanssenFit {
  std::string file;             ///< must be given
  std::int64_t parameters = 2;  ///< 1: lambda_1 = lambda_2
  std::string direction = "rest";
  double mass_per_height = std::numeric_limits<double>::quiet_NaN();  ///< [M/L] must be given

  static constexpr ModelText text{.name = "janssen-fit",
                                  .about = "Screening lengths fitted to apparent masses of columns",
                                  .source = "Bratberg 2003 (thesis), eqs (25) and (38), corrected"};
};

void parameters(JanssenFit& fit, Parameters& to);

/// A table with the columns height, apparent_mass, fitted, residual (apparent_mass minus fitted), and
/// apparent_mass_error if the file has it. Throws InputError if the file is invalid or its data do not determine the
/// lengths.
Table evaluate(const JanssenFit& fit);

}  // namespace repose::theory
