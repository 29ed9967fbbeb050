// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// Cells of at least a given size over points in space; level axes that are periodic have whole cells around the box.
class CubeGrid {
 public:
  using Cell = std::array<long, 3>;

  CubeGrid(const std::vector<Vec<3>>& points, const Box<3>& box, double size)
      : wraps_{box.periodic, box.periodic_y, false} {
    Vec<3> low = points.front();
    Vec<3> high = low;
    for (const auto& point : points) {
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], point[k]);
        high[k] = std::max(high[k], point[k]);
      }
    }
    if (box.periodic) low[0] = box.x_min, high[0] = box.x_max;
    if (box.periodic_y) low[1] = box.y_min, high[1] = box.y_max;
    origin_ = low;
    // A few points far away must not need many cells: cells grow until their number is a small multiple of the points'.
    const double most = 4.0 * static_cast<double>(points.size()) + 64.0;
    double cells = 0.0;
    do {
      cells = 1.0;
      for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const double count = std::floor((high[k] - low[k]) / size) + (wraps_[axis] ? 0.0 : 1.0);
        count_[axis] = static_cast<long>(std::clamp(count, 1.0, most));
        cells *= std::max(count, 1.0);
        size_[axis] = wraps_[axis] ? (high[k] - low[k]) / static_cast<double>(count_[axis]) : size;
      }
      size *= 1.25;
    } while (cells > most);
    start_.assign(static_cast<std::size_t>(cells) + 1, 0);
    for (const auto& point : points) ++start_[number_of(cell_of(point)) + 1];
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    auto next = start_;
    order_.resize(points.size());
    for (std::uint32_t k = 0; k < points.size(); ++k) order_[next[number_of(cell_of(points[k]))]++] = k;
  }

  Cell cell_of(const Vec<3>& point) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const auto place = static_cast<long>(std::floor((point[k] - origin_[k]) / size_[axis]));
      cell[axis] = std::clamp(place, 0L, count_[axis] - 1);
    }
    return cell;
  }

  /// Calls visit(k) for every point in the cell and in those around it, each once.
  template <class Visit>
  void for_near(const Cell& cell, const Visit& visit) const {
    std::array<std::array<long, 3>, 3> near{};
    std::array<std::size_t, 3> counts{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Where fewer than three cells wrap, the neighbours on both sides are the same.
      const long least = wraps_[axis] && count_[axis] < 3 ? 0 : -1;
      const long most = wraps_[axis] && count_[axis] == 1 ? 0 : 1;
      for (long step = least; step <= most; ++step) {
        long at = cell[axis] + step;
        if (wraps_[axis]) at = (at + count_[axis]) % count_[axis];
        if (at >= 0 && at < count_[axis]) near[axis][counts[axis]++] = at;
      }
    }
    for (std::size_t a = 0; a < counts[0]; ++a) {
      for (std::size_t b = 0; b < counts[1]; ++b) {
        for (std::size_t c = 0; c < counts[2]; ++c) {
          const auto number = number_of({near[0][a], near[1][b], near[2][c]});
          for (auto place = start_[number]; place < start_[number + 1]; ++place) visit(order_[place]);
        }
      }
    }
  }

 private:
  std::size_t number_of(const Cell& cell) const {
    return static_cast<std::size_t>((cell[0] * count_[1] + cell[1]) * count_[2] + cell[2]);
  }

  std::array<bool, 3> wraps_{};
  Vec<3> origin_{};
  std::array<double, 3> size_{};
  std::array<long, 3> count_{};
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> order_;
};

/// Calls visit(i, j) with i > j once for every pair of positions that may be nearer than `reach` [L] by the nearest
/// image, by ascending i. Some visited pairs are farther apart. Positions in a periodic box must be wrapped; all must
/// be finite.
template <class Visit>
void for_near_pairs(const std::vector<Vec<3>>& positions, const Box<3>& box, double reach, const Visit& visit) {
  if (positions.empty() || !(reach > 0.0)) return;
  // Cells are a little larger than the reach, so that rounding of cell numbers cannot put a pair two cells apart.
  const CubeGrid cells(positions, box, reach * (1.0 + 1e-6));
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    cells.for_near(cells.cell_of(positions[i]), [&](std::uint32_t j) {
      if (j < i) visit(i, j);
    });
  }
}

}  // namespace repose
