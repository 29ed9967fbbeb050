// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace repose::theory {

/// How a column moves against its walls, which sets the sign of their friction.
inline const std::vector<Word>& column_directions() {
  static const std::vector<Word> words = {"rest", "pushed-up"};
  return words;
}

/// Sense of the friction of the walls on the grains, positive upward: +1 at rest (walls carry), -1 pushed up (walls
/// hold back).
inline double wall_sense(const std::string& direction) { return direction == "rest" ? 1.0 : -1.0; }

/// (1 - exp(-x)) / x, the share of the weight of a column of x screening lengths that arrives at its bottom; 1 at x = 0
/// and above 1 for x < 0 (pushed up).
inline double share_at_bottom(double x) { return x == 0.0 ? 1.0 : -std::expm1(-x) / x; }

/// Height over screening length above which a column pushed up is refused: exp(x) would soon overflow.
inline constexpr double highest_push = 700.0;

}  // namespace repose::theory
