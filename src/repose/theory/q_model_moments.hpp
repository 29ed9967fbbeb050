// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/q_model.hpp"

#include <vector>

namespace repose::theory {

/// The second moments of the fractions of a site with n receivers: E q_k^2 and E q_k q_l (0 if n is 1). For
/// Dirichlet(r) they are (r + 1)/(n (n r + 1)) and r/(n (n r + 1)); fixed and critical are the limits r = infinity and
/// 0.
struct FractionMoments {
  double same = 1.0;
  double different = 0.0;
};
FractionMoments fraction_moments(const QModel& model, std::int64_t count);

/// The exact variance of a weight divided by mean^2 in layers 0 to `layers` (0 if the mean is 0): the mean over sites
/// of E (w/m - 1)^2, m the mean over sites. In a periodic model it follows from the recursion of the covariance C(s) of
/// sites s apart,
///   C'(s) = N^-2 sum_kl C(s + k - l) + sum_{kl: s + k - l = 0} (E q_k q_l - N^-2)(C(0) + m^2), m' = m + injection.
/// With walls the recursion is that of the whole matrix E w_i w_j, width^2 numbers.
std::vector<double> exact_variance(const QModel& model);

}  // namespace repose::theory
