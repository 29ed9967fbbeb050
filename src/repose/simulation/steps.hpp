// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace repose {

/// A duration in whole steps, at least one. What would take longer than any run is cut to a number that still counts.
inline long steps_in(double time, double time_step) {
  constexpr double most = 1e15;
  return std::max(1L, std::lround(std::min(time / time_step, most)));
}

}  // namespace repose
