// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace repose::theory {

/// Apparent masses measured below columns of several heights.
struct ApparentMasses {
  std::vector<double> height;  ///< [L] (n,), >= 0
  std::vector<double> mass;    ///< [M] (n,)
  std::vector<double> error;   ///< [M] (n,), > 0, standard deviations; empty if unknown
};

/// The fitted law: m' lambda_1 (1 - exp(-h/lambda_2)) at rest, m' lambda_1 (exp(h/lambda_2) - 1) pushed up.
struct ScreeningLaw {
  double mass_per_height = 0.0;  ///< m' [M/L]
  double sense = 1.0;            ///< +1 at rest, -1 pushed up
  std::int64_t parameters = 2;   ///< 1: lambda_1 = lambda_2
};

/// The result of the least-squares fit: lengths [L] with their standard errors. Without errors of the data, the errors
/// of the lengths are scaled by the variance of the residuals, and are NaN without a degree of freedom.
struct ScreeningFit {
  double lambda_1 = 0.0;
  double lambda_2 = 0.0;
  double lambda_1_error = 0.0;
  double lambda_2_error = 0.0;
  double correlation = 0.0;  ///< of the errors of the two lengths; 1 if there is one length
  double chi_square = 0.0;   ///< sum of squares of residuals over errors; without errors, of residuals [M^2]
  std::int64_t degrees_of_freedom = 0;
  double rms_residual = 0.0;   ///< [M] unweighted
  std::vector<double> fitted;  ///< [M] (n,)
};

/// Fits by variable projection. lambda_1 is linear for a given lambda_2. A grid over all scales of lambda_2 finds the
/// least misfit, then the root of the derivative is found to the last bits. Throws InputError if the data do not
/// determine the lengths.
/// Validated by tests/theory/screening_fit_test.cpp.
ScreeningFit fit_screening(const ScreeningLaw& law, const ApparentMasses& data);

}  // namespace repose::theory
