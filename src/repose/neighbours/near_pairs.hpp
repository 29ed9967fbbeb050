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

/// Calls visit(i, j) once for every pair of positions that may be nearer than `reach` [L] by the nearest image, in an
/// order that follows the cells. Some visited pairs are farther apart. i and j are indices into `positions`, in either
/// order. Positions in a periodic box must be wrapped; all must be finite.
template <class Visit>
void for_near_pairs(const std::vector<Vec<2>>& positions, const Box<2>& box, double reach, const Visit& visit) {
  if (positions.empty() || !(reach > 0.0)) return;
  // Cells are a little larger than the reach, so that rounding of cell numbers cannot put a pair two cells apart.
  const CellGrid<2> grid(positions, box, reach * (1.0 + 1e-6));
  const auto& order = grid.order();
  const int lines = grid.count(0);
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    const auto i = order[place];
    const auto cell = grid.cell_of(positions[i]);
    const auto own = grid.places(cell[0], cell[1], cell[1] + 1);
    for (auto other = place + 1; other < own.end; ++other) visit(i, order[other]);
    // Where cells wrap, two lines would meet twice, and one line would meet itself.
    const bool last = cell[0] + 1 == lines;
    if (last && (!box.periodic || lines < 3)) continue;
    const auto beside = grid.places(last ? 0 : cell[0] + 1, cell[1] - 1, cell[1] + 1);
    for (auto other = beside.begin; other < beside.end; ++other) visit(i, order[other]);
  }
}

}  // namespace repose
