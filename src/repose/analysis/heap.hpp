// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <optional>
#include <vector>

namespace repose {

/// One bin of the surface profile.
struct SurfaceBin {
  double x = 0.0;       ///< [L] centre of the bin
  double height = 0.0;  ///< [L] top of the highest grain in the bin, above the base
  bool used = false;    ///< whether the line of its flank is fitted to it
};

/// The line h = slope x + intercept through one flank of a heap.
struct FlankLine {
  double slope = 0.0;
  double intercept = 0.0;  ///< [L]
  double angle_deg = 0.0;  ///< angle of repose: between line and base, positive for a flank that falls outwards
};

/// The shape of a heap.
struct HeapShape {
  std::vector<SurfaceBin> surface;  ///< contiguous from the apex, by ascending x; empty without a heap
  double apex_x = 0.0;              ///< [L]
  double apex_height = 0.0;         ///< [L] above the base
  std::optional<FlankLine> left;
  std::optional<FlankLine> right;
  /// atan(<y>/<|x - <x>|>), exact for a triangle of uniform density; none unless the surface falls below half the
  /// height of the apex at both ends, since a bed between walls has no such angle.
  std::optional<double> moments_angle_deg;
};

/// The depth [L] below the surface of a point at `height` above the base, perpendicular to the flank on its side of the
/// apex; negative above the surface. The surface is linear between the centres of its bins and level beyond the
/// outermost.
double depth_below_surface(const HeapShape& heap, double x, double height);

/// One flag per grain, in memory order: whether it is part of the heap, that is, moving, with a contact, and at a
/// finite position.
template <int D>
std::vector<bool> supported(const Grains<D>& grains, const Contacts<D>& contacts);

/// Whether walls steeper than 45 degrees bear more than a hundredth of the weight [M L/T^2]: a bed in a box, a column
/// or a drum has no free flanks.
template <int D>
bool leans_on_steep_walls(const Contacts<D>& contacts, double weight);

/// Measures the surface profile and the angles of repose in the plane of the first and the last axis. Bins are
/// `bin_width` [L] wide, with edges at its multiples. The height of a bin is that of the highest grain top above
/// `base_height` [L]. Only bins connected to the apex without a gap count. The line of a flank is the least-squares
/// line through its bins between 10 % and 90 % of the height of the apex.
template <int D>
HeapShape measure_heap(const Grains<D>& grains, const std::vector<bool>& in_heap, double base_height, double bin_width);

}  // namespace repose
