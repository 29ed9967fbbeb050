// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>
#include <limits>
#include <string>

namespace repose::theory {

/// Janssen's law with one or two lengths, fitted to apparent masses of columns: a CSV file with columns height [L],
/// apparent_mass [M] and, where they are known, apparent_mass_error [M], in any order, others left alone.
/// Source: Bratberg's thesis (2003), eqs (25) and (38), corrected. Validated by tests/theory/screening_fit_test.cpp.
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

/// Columns height, apparent_mass, fitted, residual (mass less fitted), and apparent_mass_error where it is given.
/// Throws InputError where the file is not as it should be or its data do not determine the lengths.
Table evaluate(const JanssenFit& fit);

}  // namespace repose::theory
