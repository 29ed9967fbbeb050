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
  double height = 0.0;  ///< [L] highest grain top in the bin above the base
  bool used = false;    ///< for the line of its flank
};

/// The line h = slope x + intercept through one flank of a heap.
struct FlankLine {
  double slope = 0.0;
  double intercept = 0.0;  ///< [L]
  double angle_deg = 0.0;  ///< angle of repose: of the line with the base, positive for a flank that falls outwards
};

/// What a first look at a heap gives.
struct HeapShape {
  std::vector<SurfaceBin> surface;  ///< contiguous from the apex, by ascending x; empty without a heap
  double apex_x = 0.0;              ///< [L]
  double apex_height = 0.0;         ///< [L] above the base
  std::optional<FlankLine> left;
  std::optional<FlankLine> right;
  std::optional<double> moments_angle_deg;  ///< atan(<y>/<|x - <x>|>), exact for a triangle of uniform density
};

/// How far [L] a point at `height` above the base lies below the surface, at right angles to the flank on its side of
/// the apex; negative above. The surface is a straight line between the centres of its bins, level beyond the
/// outermost.
double depth_below_surface(const HeapShape& heap, double x, double height);

/// Which moving grains are part of the heap: those that touch something (one flag per grain, in memory order).
template <int D>
std::vector<bool> supported(const Grains<D>& grains, const Contacts<D>& contacts);

/// Surface profile and angles of repose in the plane of the first and the last axis. Bins of `bin_width` [L] with edges
/// at its multiples; the height of a bin is the highest grain top above `base_height`; bins count while they follow on
/// from the apex without a gap; least-squares line through the bins between 10 % and 90 % of the height of the apex.
template <int D>
HeapShape measure_heap(const Grains<D>& grains, const std::vector<bool>& in_heap, double base_height, double bin_width);

}  // namespace repose
