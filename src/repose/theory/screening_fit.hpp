// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace repose::theory {

/// Apparent mass measured below columns of several heights.
struct ApparentMasses {
  std::vector<double> height;  ///< [L] (n,), >= 0
  std::vector<double> mass;    ///< [M] (n,)
  std::vector<double> error;   ///< [M] (n,), > 0, standard deviations; empty where they are not known
};

/// What is fitted: m' lambda_1 (1 - exp(-h/lambda_2)) at rest, m' lambda_1 (exp(h/lambda_2) - 1) pushed up.
struct ScreeningLaw {
  double mass_per_height = 0.0;  ///< m' [M/L]
  double sense = 1.0;            ///< +1 at rest, -1 pushed up
  std::int64_t parameters = 2;   ///< 1: lambda_1 = lambda_2
};

/// Least squares: lengths [L] with their standard errors. Without errors of the data, those of the lengths are scaled
/// by the variance of the residuals; not-a-number where no degree of freedom is left for it.
struct ScreeningFit {
  double lambda_1 = 0.0;
  double lambda_2 = 0.0;
  double lambda_1_error = 0.0;
  double lambda_2_error = 0.0;
  double correlation = 0.0;  ///< of the two lengths; 1 where they are one
  double chi_square = 0.0;   ///< of residuals over errors; without errors their sum of squares [M^2]
  std::int64_t degrees_of_freedom = 0;
  double rms_residual = 0.0;   ///< [M], not weighted
  std::vector<double> fitted;  ///< [M] (n,)
};

/// Fits by variable projection: lambda_1 is linear given lambda_2, for which all scales are searched, then the root of
/// the derivative is found to the last bits. Throws InputError where the data do not determine the lengths.
/// Validated by tests/theory/screening_fit_test.cpp.
ScreeningFit fit_screening(const ScreeningLaw& law, const ApparentMasses& data);

}  // namespace repose::theory
