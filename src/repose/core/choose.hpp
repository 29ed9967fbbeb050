// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/inline.hpp"

#include <cmath>

namespace repose {

// The arithmetic of laws. Their text is the same for one pair of grains, where T is double, and for several at once,
// where T is a pack of numbers (core/pack.hpp). So it chooses between results instead of branching, and uses these
// functions instead of those of <cmath>. A pack has the same functions with the same bits.

REPOSE_FN double choose(bool condition, double yes, double no) { return condition ? yes : no; }
REPOSE_FN double root(double a) { return std::sqrt(a); }
REPOSE_FN double magnitude(double a) { return std::fabs(a); }
REPOSE_FN double with_sign_of(double a, double sign) { return std::copysign(a, sign); }

/// As std::max and std::min, also for two zeros.
template <class T>
REPOSE_FN T larger(const T& a, const T& b) {
  return choose(a < b, b, a);
}
template <class T>
REPOSE_FN T smaller(const T& a, const T& b) {
  return choose(b < a, b, a);
}
template <class T>
REPOSE_FN T positive_part(const T& a) {
  return choose(a > T(0.0), a, T(0.0));
}

}  // namespace repose
