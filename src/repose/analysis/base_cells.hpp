// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_rings.hpp"
#include "repose/core/box.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace repose {

/// The loads in one cell of a base, as a sensor of this size in the base reads them.
struct BaseCell {
  double x = 0.0;          ///< [L] of its middle
  double y = 0.0;          ///< [L]
  std::int64_t count = 0;  ///< loads in it
  double pressure = 0.0;   ///< [M/(L T^2)] normal force over the area of the cell, positive downwards
  double shear_x = 0.0;    ///< [M/(L T^2)] force on the base along x over that area
  double shear_y = 0.0;    ///< [M/(L T^2)] along y
};

/// A base divided into equal cells.
struct BaseCells {
  std::vector<BaseCell> cells;       ///< that hold a load, by ascending x, then y; all others read nothing
  std::array<double, 2> side{};      ///< [L] of a cell along x and y
  double load = 0.0;                 ///< [M L/T^2] the sum of all normal forces
  std::array<double, 2> traction{};  ///< [M L/T^2] the sum of all shear forces along x and y

  double area() const { return side[0] * side[1]; }  ///< [L^2] of a cell
};

/// Sums the loads in square cells of this width [L]. The middle of one cell lies at x = y = 0. Along a periodic axis
/// the cells begin at the edge of the box, and their side is the one nearest to the width that divides the box. A load
/// on an edge counts in the cell of larger x or y. The whole area of a cell counts, also at the edge of a base that
/// covers a part of it, so pressure times area, summed over all cells, is the load. Places that are not finite are
/// left out. Validated by tests/unit/base_cells_test.cpp.
BaseCells measure_base_cells(const std::vector<BaseLoad>& loads, double width, const Box<3>& box);

}  // namespace repose
