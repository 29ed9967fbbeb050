// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>

namespace repose {

/// Area [L^2] of the part of a disc of this radius about the origin that has y < height: the disc less a circular
/// segment, r^2 (pi - acos(h/r)) + h sqrt(r^2 - h^2). Exact to rounding.
double disc_area_below(double radius, double height);

/// Area [L^2] of the part of a disc about the origin in the quadrant x < right, y < top. Exact to rounding.
double disc_area_in_quadrant(double radius, double right, double top);

struct Rectangle {
  Vec<2> low{};   ///< [L] lower left corner
  Vec<2> high{};  ///< [L] upper right corner
};

/// Area [L^2] of the part of a disc in a rectangle: four quadrants, added and subtracted. Error about 1e-15 r^2.
double disc_area_in(const Vec<2>& centre, double radius, const Rectangle& rectangle);

/// Share of the slab's area that discs (of the base too) cover, cut exactly at the slab's edges and, where the box is
/// not periodic, at its sides. Discs must not overlap, else their common area counts twice. The error is the jackknife
/// over `blocks` blocks along x, at whose edges the areas are cut exactly too. Validated by
/// tests/unit/solid_fraction_test.cpp.
Estimate solid_fraction(const Discs& discs, const Slab& slab, std::size_t blocks);

}  // namespace repose
