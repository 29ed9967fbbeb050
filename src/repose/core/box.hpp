// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cmath>
#include <limits>

namespace repose {

/// The region of space that is simulated. x is open or periodic; a grain whose centre leaves an open region is lost.
template <int D>
struct Box {
  bool periodic = false;                                    ///< x wraps from x_max to x_min
  double x_min = -std::numeric_limits<double>::infinity();  ///< [L]
  double x_max = std::numeric_limits<double>::infinity();   ///< [L]
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] a grain below this height is lost

  REPOSE_FN double width() const { return x_max - x_min; }

  /// True if a grain at this place has left for good.
  bool outside(const Vec<D>& position) const {
    if (position[up<D>] < floor) return true;
    return !periodic && (position[0] < x_min || position[0] > x_max);
  }

  /// Position with x brought into [x_min, x_max) where periodic.
  Vec<D> wrapped(Vec<D> position) const {
    if (!periodic) return position;
    position[0] -= width() * std::floor((position[0] - x_min) / width());
    if (position[0] >= x_max) position[0] = x_min;  // rounding of a place just below x_min
    return position;
  }
};

/// Separation a - b by the nearest image. Positions may lie up to half a width outside a periodic box.
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
REPOSE_FN Vec<D> separation(const Vec<D>& a, const Vec<D>& b, const Box<D>& box) {
  return box.periodic ? separation<true>(a, b, box) : separation<false>(a, b, box);
}

}  // namespace repose
