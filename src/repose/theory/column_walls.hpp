// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace repose::theory {

/// The motions of a column relative to its walls. They set the sign of the wall friction.
inline const std::vector<Word>& column_directions() {
  static const std::vector<Word> words = {"rest", "pushed-up"};
  return words;
}

/// The sign of the wall friction on the grains, positive upward: +1 at rest (the walls carry weight), -1 pushed up (the
/// walls hold the grains down).
inline double wall_sense(const std::string& direction) { return direction == "rest" ? 1.0 : -1.0; }

/// (1 - exp(-x)) / x: the fraction of the weight of a column, x screening lengths high, that its bottom carries. It is
/// 1 at x = 0 and above 1 for x < 0 (pushed up).
inline double fraction_at_bottom(double x) { return x == 0.0 ? 1.0 : -std::expm1(-x) / x; }

/// The largest ratio of height to screening length of a column that is pushed up: exp(x) soon overflows beyond it.
inline constexpr double highest_push = 700.0;

}  // namespace repose::theory
