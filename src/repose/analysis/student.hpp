// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// Student's t that a variable with so many degrees of freedom (> 0) exceeds with probability 1 - `probability`.
double student_quantile(double probability, double freedom);
/// The probability that such a variable is at most `t`, which may be infinite.
double student_probability(double t, double freedom);

/// The same for the standard normal distribution.
double normal_quantile(double probability);
double normal_probability(double z);

/// `x` to ten digits. Quantiles and probabilities come from the C library, whose last bits depend on the processor;
/// tables of a sweep must not.
double ten_digits(double x);

}  // namespace repose
