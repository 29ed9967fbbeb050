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
template <int D, class Visit>
void for_near_pairs(const std::vector<Vec<D>>& positions, const Box<D>& box, double reach, const Visit& visit) {
  if (positions.empty() || !(reach > 0.0)) return;
  // Cells are a little larger than the reach, so that rounding of cell numbers cannot put a pair two cells apart.
  const CellGrid<D> grid(positions, box, reach * (1.0 + 1e-6));
  const auto& order = grid.order();
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    const auto i = order[place];
    const auto cell = grid.cell_of(positions[i]);
    const int height = cell[D - 1];
    const auto own = grid.places(grid.line_of(cell), height, height + 1);
    for (auto other = place + 1; other < own.end; ++other) visit(i, order[other]);
    const auto visit_line = [&](int line) {
      const auto beside = grid.places(line, height - 1, height + 1);
      for (auto other = beside.begin; other < beside.end; ++other) visit(i, order[other]);
    };
    if constexpr (D == 2) {
      // Where cells wrap, two lines would meet twice, and one line would meet itself.
      const int lines = grid.count(0);
      const bool last = cell[0] + 1 == lines;
      if (last && (!box.periodic || lines < 3)) continue;
      visit_line(last ? 0 : cell[0] + 1);
    } else {
      for (const int line : grid.later_lines(cell, box)) visit_line(line);
    }
  }
}

}  // namespace repose
