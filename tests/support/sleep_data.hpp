// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace repose {

// The sleep that ten patients gained by two drugs (Student 1908, Biometrika 6, 1), the best known pairs of statistics.
// Expected numbers in tests were computed from the formulas with mpmath, to 40 digits.
inline const std::vector<double> first_drug = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
inline const std::vector<double> second_drug = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

}  // namespace repose
