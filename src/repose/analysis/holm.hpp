// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace repose {

/// P-values adjusted for their number by Holm's step-down rule (Scand. J. Statist. 6, 65, 1979): if every hypothesis
/// with an adjusted p-value of at most a level is rejected, the probability of any wrong rejection is at most that
/// level. NaNs stay NaN and do not count. Validated by tests/unit/inference_test.cpp.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace repose
