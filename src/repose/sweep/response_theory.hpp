// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"
#include "repose/sweep/response.hpp"

#include <algorithm>

namespace repose {

/// Length that the intervals from a to b and from c to d share.
inline double shared_length(double a, double b, double c, double d) {
  return std::max(0.0, std::min(b, d) - std::max(a, c));
}

/// Adds the curves of theory to a response whose bins are measured; the load is as wide as a grain of the base, whose
/// grains stand `pitch` [L] apart.
void compare_with_theory(PointResponse& response, const Scene& scene, double pitch);

}  // namespace repose
