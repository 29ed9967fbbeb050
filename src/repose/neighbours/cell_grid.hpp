// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace repose {

/// Whether an axis of the box wraps, and its length [L] if so.
template <int D>
bool wraps_along(const Box<D>& box, int axis) {
  if (axis == 0) return box.periodic;
  return D == 3 && axis == 1 && box.periodic_y;
}
template <int D>
double length_along(const Box<D>& box, int axis) {
  return axis == 0 ? box.width() : box.depth();
}

/// A few lines of cells, by their numbers.
struct Lines {
  std::array<int, 9> line{};
  std::size_t count = 0;

  void add(int number) { line[count++] = number; }
  const int* begin() const { return line.data(); }
  const int* end() const { return line.data() + count; }
};

/// A grid of cells over the grains, numbered so that the last axis (height) runs fastest. So a line of cells along it
/// is contiguous in memory order, and three neighbouring cells of a line are one range.
template <int D>
class CellGrid {
 public:
  CellGrid() = default;
  CellGrid(const std::vector<Vec<D>>& positions, const Box<D>& box, double cell_size) {
    build(positions, box, cell_size);
  }

  /// Covers all positions with cells of at least `cell_size` [L]. Positions in a periodic box must be wrapped. The
  /// memory of the last grid is used again.
  void build(const std::vector<Vec<D>>& positions, const Box<D>& box, double cell_size);

  /// Stable order by cell: entry k is the old index of the grain that becomes the k-th.
  const std::vector<std::uint32_t>& order() const { return order_; }

  std::array<int, D> cell_of(const Vec<D>& position) const;
  int count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }
  double size(int axis) const { return size_[static_cast<std::size_t>(axis)]; }

  /// The range of indices, in the new order, of the grains in cells first..last (clamped to the grid) of one line.
  struct Places {
    std::uint32_t begin;
    std::uint32_t end;
  };
  Places places(int line, int first, int last) const {
    const int height = count(D - 1);
    const auto base = static_cast<std::size_t>(line) * static_cast<std::size_t>(height);
    const auto low = base + static_cast<std::size_t>(std::clamp(first, 0, height - 1));
    const auto high = base + static_cast<std::size_t>(std::clamp(last, 0, height - 1));
    return {start_[low], start_[high + 1]};
  }

  /// Number of the line of cells through a cell.
  int line_of(const std::array<int, D>& cell) const {
    int line = cell[0];
    for (int axis = 1; axis < D - 1; ++axis) line = line * count(axis) + cell[static_cast<std::size_t>(axis)];
    return line;
  }

  /// The lines next to a cell, those across a periodic boundary too, that have higher numbers than its own: each once,
  /// ascending. So every two lines that are next to each other meet once.
  Lines later_lines(const std::array<int, D>& cell, const Box<D>& box) const;

  /// The lowest cell of a line.
  std::array<int, D> foot_of(int line) const {
    std::array<int, D> cell{};
    for (int axis = D - 2; axis > 0; --axis) {
      cell[static_cast<std::size_t>(axis)] = line % count(axis);
      line /= count(axis);
    }
    cell[0] = line;
    return cell;
  }

 private:
  std::size_t index(const std::array<int, D>& cell) const {
    return static_cast<std::size_t>(line_of(cell)) * static_cast<std::size_t>(count(D - 1)) +
           static_cast<std::size_t>(cell[D - 1]);
  }

  Vec<D> origin_{};
  std::array<double, D> size_{};
  std::array<double, D> inverse_size_{};
  std::array<int, D> count_{};
  std::vector<std::uint32_t> start_;  // first place of each cell, one more at the end
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> cell_;  // of each position, while the grid is built
};

}  // namespace repose
