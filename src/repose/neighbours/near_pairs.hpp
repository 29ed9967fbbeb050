// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"
#include "repose/neighbours/cell_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// Calls visit(i, j) once for every pair of places that may be nearer than `reach` [L] by the nearest image, in an
/// order that follows the cells; visits pairs that are farther apart too. i and j are places in `positions`, in either
/// order. Positions of a periodic box must be wrapped; none may be infinite or not a number.
template <class Visit>
void for_near_pairs(const std::vector<Vec<2>>& positions, const Box<2>& box, double reach, const Visit& visit) {
  if (positions.empty() || !(reach > 0.0)) return;
  // A little more than the reach, so that rounding of cell numbers cannot put a pair two cells apart.
  const CellGrid<2> grid(positions, box, reach * (1.0 + 1e-6));
  const auto& order = grid.order();
  const int lines = grid.count(0);
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    const auto i = order[place];
    const auto cell = grid.cell_of(positions[i]);
    const auto own = grid.places(cell[0], cell[1], cell[1] + 1);
    for (auto other = place + 1; other < own.end; ++other) visit(i, order[other]);
    // Two lines that wrap would meet twice, one line itself.
    const bool last = cell[0] + 1 == lines;
    if (last && (!box.periodic || lines < 3)) continue;
    const auto beside = grid.places(last ? 0 : cell[0] + 1, cell[1] - 1, cell[1] + 1);
    for (auto other = beside.begin; other < beside.end; ++other) visit(i, order[other]);
  }
}

}  // namespace repose
