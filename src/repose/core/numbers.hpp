// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <numbers>

namespace repose {

/// Stands where there is no number.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

}  // namespace repose
