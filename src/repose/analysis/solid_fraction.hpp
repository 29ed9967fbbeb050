// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>

namespace repose {

/// Area [L^2] of the part y < height of a disc about the origin: the disc minus a circular segment,
/// r^2 (pi - acos(h/r)) + h sqrt(r^2 - h^2). Exact to rounding.
double disc_area_below(double radius, double height);

/// Area [L^2] of the part of a disc about the origin that lies in the quadrant x < right, y < top. Exact to rounding.
double disc_area_in_quadrant(double radius, double right, double top);

struct Rectangle {
  Vec<2> low{};   ///< [L] lower left corner
  Vec<2> high{};  ///< [L] upper right corner
};

/// Area [L^2] of the part of a disc that lies in a rectangle, from four quadrants. Error about 1e-15 r^2.
double disc_area_in(const Vec<2>& centre, double radius, const Rectangle& rectangle);

/// The fraction of the slab's area that discs cover, base discs included. Discs are cut exactly at the edges of the
/// slab and, if the box is not periodic, at its sides. Areas where discs overlap count twice. The error is the
/// jackknife over `blocks` blocks along x, at whose edges discs are cut exactly too. Validated by
/// tests/unit/solid_fraction_test.cpp.
Estimate solid_fraction(const Discs& discs, const Slab& slab, std::size_t blocks);

}  // namespace repose
