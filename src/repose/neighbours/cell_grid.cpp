// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/neighbours/cell_grid.hpp"

#include <cstddef>

namespace repose {

template <int D>
void CellGrid<D>::build(const std::vector<Vec<D>>& positions, const Box<D>& box, double cell_size) {
  Vec<D> low = positions.empty() ? Vec<D>{} : positions.front();
  Vec<D> high = low;
  for (const auto& position : positions) {
    for (int axis = 0; axis < D; ++axis) {
      low[axis] = std::min(low[axis], position[axis]);
      high[axis] = std::max(high[axis], position[axis]);
    }
  }
  if (box.periodic) {
    low[0] = box.x_min;
    high[0] = box.x_max;
  }
  if constexpr (D == 3) {
    if (box.periodic_y) {
      low[1] = box.y_min;
      high[1] = box.y_max;
    }
  }
  origin_ = low;

  // A few grains far away must not make the grid huge: cells grow until their number is a small multiple of the
  // grains'.
  const double most_cells = 16.0 * static_cast<double>(positions.size()) + 1024.0;
  for (double size = cell_size;; size *= 1.5) {
    double cells = 1.0;
    for (int axis = 0; axis < D; ++axis) cells *= std::floor((high[axis] - low[axis]) / size) + 1.0;
    if (cells > most_cells) continue;
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const bool wraps = wraps_along(box, axis);
      const double extent = high[axis] - low[axis];
      count_[a] = std::max(1, static_cast<int>(std::floor(extent / size)) + (wraps ? 0 : 1));
      size_[a] = wraps ? extent / count_[a] : size;
      inverse_size_[a] = 1.0 / size_[a];
    }
    break;
  }

  std::size_t cells = 1;
  for (const int n : count_) cells *= static_cast<std::size_t>(n);
  // start_[c + 1] counts the grains of cell c, then is its first place, and after the last loop that of cell c + 1.
  cell_.resize(positions.size());
  start_.assign(cells + 2, 0);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    cell_[k] = static_cast<std::uint32_t>(index(cell_of(positions[k])));
    ++start_[cell_[k] + 2];
  }
  for (std::size_t c = 2; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    order_[start_[cell_[k] + 1]++] = static_cast<std::uint32_t>(k);
  }
}

template <int D>
std::array<int, D> CellGrid<D>::cell_of(const Vec<D>& position) const {
  std::array<int, D> cell{};
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double place = (position[axis] - origin_[axis]) * inverse_size_[a];
    cell[a] = static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count_[a] - 1)));  // rounded down
  }
  return cell;
}

template <int D>
Lines CellGrid<D>::later_lines(const std::array<int, D>& cell, const Box<D>& box) const {
  Lines lines;
  if constexpr (D == 2) {
    const int last = count(0) - 1;
    if (cell[0] < last) lines.add(cell[0] + 1);
    if (box.periodic && cell[0] == 0 && last > 1) lines.add(last);
  } else {
    // The cells of one axis that are next to a cell or its own, each once: a short axis that wraps has them twice.
    const auto near = [&](int axis) {
      Lines all;
      const int own = cell[static_cast<std::size_t>(axis)];
      const int cells = count(axis);
      for (int place = own - 1; place <= own + 1; ++place) {
        const bool inside = place >= 0 && place < cells;
        if (!inside && !wraps_along(box, axis)) continue;
        const int number = (place + cells) % cells;
        if (std::find(all.begin(), all.end(), number) == all.end()) all.add(number);
      }
      return all;
    };
    const auto own = line_of(cell);
    const auto ys = near(1);
    for (const int x : near(0)) {
      for (const int y : ys) {
        if (x * count(1) + y > own) lines.add(x * count(1) + y);
      }
    }
    std::sort(lines.line.begin(), lines.line.begin() + static_cast<std::ptrdiff_t>(lines.count));
  }
  return lines;
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace repose
