// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cmath>
#include <limits>

namespace repose {

/// The simulated region of space. Level axes, x and in three dimensions y too, are open or periodic; a grain whose
/// centre leaves an open region is lost.
template <int D>
struct Box {
  bool periodic = false;                                    ///< x wraps from x_max to x_min
  double x_min = -std::numeric_limits<double>::infinity();  ///< [L]
  double x_max = std::numeric_limits<double>::infinity();   ///< [L]
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] a grain below this height is lost
  // In three dimensions alone.
  bool periodic_y = false;                                  ///< y wraps from y_max to y_min
  double y_min = -std::numeric_limits<double>::infinity();  ///< [L]
  double y_max = std::numeric_limits<double>::infinity();   ///< [L]

  REPOSE_FN double width() const { return x_max - x_min; }
  REPOSE_FN double depth() const { return y_max - y_min; }  ///< [L] along y, in three dimensions

  /// Whether any axis wraps.
  bool wraps() const { return periodic || (D == 3 && periodic_y); }

  /// Whether a grain with its centre here is lost.
  bool outside(const Vec<D>& position) const {
    if (position[up<D>] < floor) return true;
    if constexpr (D == 3) {
      if (!periodic_y && (position[1] < y_min || position[1] > y_max)) return true;
    }
    return !periodic && (position[0] < x_min || position[0] > x_max);
  }

  /// The position with each level axis moved into its range, such as [x_min, x_max), if it is periodic.
  Vec<D> wrapped(Vec<D> position) const {
    if (periodic) position[0] = wrapped_into(position[0], x_min, x_max);
    if constexpr (D == 3) {
      if (periodic_y) position[1] = wrapped_into(position[1], y_min, y_max);
    }
    return position;
  }

 private:
  static double wrapped_into(double place, double low, double high) {
    if (place >= low && place < high) return place;
    place -= (high - low) * std::floor((place - low) / (high - low));
    return place >= high ? low : place;  // a place just below `low` rounds up to `high`
  }
};

/// The difference of two places on a periodic axis of this length [L] by the nearest image.
REPOSE_FN double nearest_image(double difference, double length) {
  const double half = 0.5 * length;
  if (difference > half) difference -= length;
  if (difference < -half) difference += length;
  return difference;
}

/// The separation a - b [L] by the nearest image. Positions may lie up to half a width outside a periodic box.
template <bool Periodic, int D>
REPOSE_FN Vec<D> separation(const Vec<D>& a, const Vec<D>& b, const Box<D>& box) {
  Vec<D> d = a - b;
  if constexpr (Periodic && D == 2) d[0] = nearest_image(d[0], box.width());
  if constexpr (Periodic && D == 3) {
    if (box.periodic) d[0] = nearest_image(d[0], box.width());
    if (box.periodic_y) d[1] = nearest_image(d[1], box.depth());
  }
  return d;
}

template <int D>
requires(D > 1)  // not the one above with D = false
    REPOSE_FN Vec<D> separation(const Vec<D>& a, const Vec<D>& b, const Box<D>& box) {
  return box.wraps() ? separation<true>(a, b, box) : separation<false>(a, b, box);
}

}  // namespace repose
