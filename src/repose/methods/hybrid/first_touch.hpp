// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cmath>
#include <limits>

namespace repose::hybrid {

inline constexpr double no_touch = std::numeric_limits<double>::infinity();

/// The first time [T], from 0 on, at which c0 + c1 t + c2 t^2 falls through zero. Where it is not positive at the start
/// (the bodies touch), that is at once if it falls, and when it is back at its value if it rises first.
inline double first_fall(double c0, double c1, double c2) {
  if (c0 <= 0.0) {
    if (c1 < 0.0) return 0.0;
    return c2 < 0.0 ? -c1 / c2 : no_touch;
  }
  const double square = c1 * c1 - 4.0 * c2 * c0;
  if (!(square >= 0.0)) return no_touch;
  const double root = std::sqrt(square);
  if (c1 < 0.0) return 2.0 * c0 / (root - c1);
  return c2 < 0.0 ? (c1 + root) / (-2.0 * c2) : no_touch;
}

/// The first time [T] at which two bodies `apart` [L] from each other, with a relative velocity and acceleration, come
/// as near as `reach` [L]. It is exact if it lies within the time `within` [T]; later ones are rough.
inline double first_touch(const Vec<2>& apart, const Vec<2>& velocity, const Vec<2>& acceleration, double reach,
                          double within) {
  const double c0 = dot(apart, apart) - reach * reach;
  const double c1 = 2.0 * dot(apart, velocity);
  const double c2 = dot(velocity, velocity) + dot(apart, acceleration);
  double time = first_fall(c0, c1, c2);
  const double c4 = 0.25 * dot(acceleration, acceleration);
  if (c4 == 0.0 || time == 0.0 || time > 2.0 * within) return time;
  // The terms of third and fourth order are small over a step: Newton's method from the root without them.
  const double c3 = dot(velocity, acceleration);
  const double level = c0 > 0.0 ? 0.0 : c0;
  constexpr int most = 20;
  for (int k = 0; k < most; ++k) {
    const double above = c0 - level + time * (c1 + time * (c2 + time * (c3 + time * c4)));
    const double slope = c1 + time * (2.0 * c2 + time * (3.0 * c3 + time * 4.0 * c4));
    const double change = above / slope;
    if (!(slope < 0.0) || std::fabs(change) > within) return time;  // they graze
    time -= change;
    if (std::fabs(change) <= 1e-15 * time) break;
  }
  return time > 0.0 ? time : 0.0;
}

}  // namespace repose::hybrid
