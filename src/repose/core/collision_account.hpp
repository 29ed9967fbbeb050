// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace repose {

/// What the hybrid method did over a number of steps.
struct CollisionAccount {
  std::int64_t steps = 0;       ///< time steps, halves of repeated ones counted
  std::int64_t hard = 0;        ///< hard collisions
  std::int64_t softened = 0;    ///< contacts that turned soft
  std::int64_t hardened = 0;    ///< soft contacts that ended
  std::int64_t iterations = 0;  ///< of Newton's method, or sweeps
  std::int64_t halved = 0;      ///< steps without a solution, repeated as two halves
  double worst_residual = 0.0;  ///< [weight of a grain] largest of all steps

  CollisionAccount& operator+=(const CollisionAccount& b) {
    steps += b.steps;
    hard += b.hard;
    softened += b.softened;
    hardened += b.hardened;
    iterations += b.iterations;
    halved += b.halved;
    worst_residual = std::max(worst_residual, b.worst_residual);
    return *this;
  }
};

}  // namespace repose
