// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cmath>
#include <limits>

namespace repose {

/// The simulated region of space. x is open or periodic; a grain whose centre leaves an open region is lost.
template <int D>
struct Box {
  bool periodic = false;                                    ///< x wraps from x_max to x_min
  double x_min = -std::numeric_limits<double>::infinity();  ///< [L]
  double x_max = std::numeric_limits<double>::infinity();   ///< [L]
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] a grain below this height is lost

  REPOSE_FN double width() const { return x_max - x_min; }

  /// Whether a grain with its centre here is lost.
  bool outside(const Vec<D>& position) const {
    if (position[up<D>] < floor) return true;
    return !periodic && (position[0] < x_min || position[0] > x_max);
  }

  /// The position with x moved into [x_min, x_max) if the box is periodic.
  Vec<D> wrapped(Vec<D> position) const {
    if (!periodic || (position[0] >= x_min && position[0] < x_max)) return position;
    position[0] -= width() * std::floor((position[0] - x_min) / width());
    if (position[0] >= x_max) position[0] = x_min;  // a position just below x_min rounds up to x_max
    return position;
  }
};

/// The separation a - b [L] by the nearest image. Positions may lie up to half a width outside a periodic box.
template <bool Periodic, int D>
REPOSE_FN Vec<D> separation(const Vec<D>& a, const Vec<D>& b, const Box<D>& box) {
  Vec<D> d = a - b;
  if constexpr (Periodic) {
    const double half = 0.5 * box.width();
    if (d[0] > half) d[0] -= box.width();
    if (d[0] < -half) d[0] += box.width();
  }
  return d;
}

template <int D>
requires(D > 1)  // not the one above with D = false
    REPOSE_FN Vec<D> separation(const Vec<D>& a, const Vec<D>& b, const Box<D>& box) {
  return box.periodic ? separation<true>(a, b, box) : separation<false>(a, b, box);
}

}  // namespace repose
