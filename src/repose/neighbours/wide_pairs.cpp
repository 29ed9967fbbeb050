// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/neighbours/wide_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace repose {

template <int D>
void WidePairs<D>::find(const Spots<D>& spots, const std::vector<double>& allowance, double slow,
                        const CellGrid<D>& grid, const Box<D>& box) {
  travel_.resize(spots.size());
  for (std::size_t k = 0; k < spots.size(); ++k) travel_[k] = allowance[k] - slow;
  wide_.clear();
  pairs_.clear();
  for (std::uint32_t k = 0; k < spots.size(); ++k) {
    if (travel_[k] > 0.0 || spots.large(k)) wide_.push_back(k);
  }
  for (const auto i : wide_) with_cells(i, spots, grid, box);
  with_each_other(spots, box);
  std::sort(pairs_.begin(), pairs_.end(),
            [](const Pair& a, const Pair& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
}

/// Pairs of two grains that both fit the cells are found by their rows where their ranges overlap.
template <int D>
void WidePairs<D>::add_if_near(std::uint32_t i, std::uint32_t j, const Spots<D>& spots, const Box<D>& box) {
  const double near = spots.range[i] + spots.range[j];
  const double within = near + travel_[i] + travel_[j];
  const double distance2 = spots.distance2(i, j, box);
  const bool in_rows = !spots.large(i) && !spots.large(j) && distance2 < near * near;
  if (distance2 < within * within && !in_rows && !spots.both_fixed(i, j)) {
    pairs_.push_back({std::min(i, j), std::max(i, j)});
  }
}

/// Pairs of a wide grain and one that is not.
template <int D>
void WidePairs<D>::with_cells(std::uint32_t i, const Spots<D>& spots, const CellGrid<D>& grid, const Box<D>& box) {
  const double range = spots.range[i] + travel_[i] + spots.cell_range;
  Vec<D> position;
  for (int axis = 0; axis < D; ++axis) position[axis] = spots.at[static_cast<std::size_t>(axis)][i];
  const auto centre = grid.cell_of(position);
  std::array<int, D> low{};
  std::array<int, D> high{};
  for (int axis = 0; axis < D; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const int cells = static_cast<int>(std::ceil(range / grid.size(axis)));
    const bool wraps = wraps_along(box, axis);
    low[a] = wraps ? centre[a] - cells : std::max(0, centre[a] - cells);
    high[a] = wraps ? centre[a] + cells : std::min(grid.count(axis) - 1, centre[a] + cells);
    if (wraps && high[a] - low[a] >= grid.count(axis)) {
      low[a] = 0;
      high[a] = grid.count(axis) - 1;
    }
  }
  const auto search_line = [&](int line) {
    const auto places = grid.places(line, low[D - 1], high[D - 1]);
    for (auto j = places.begin; j < places.end; ++j) {
      const bool also_wide = travel_[j] > 0.0 || spots.large(j);
      if (!also_wide) add_if_near(i, j, spots, box);
    }
  };
  const auto inside = [&](int place, int axis) {
    return ((place % grid.count(axis)) + grid.count(axis)) % grid.count(axis);
  };
  for (int x = low[0]; x <= high[0]; ++x) {
    const int column = inside(x, 0);
    if constexpr (D == 2) {
      search_line(column);
    } else {
      for (int y = low[1]; y <= high[1]; ++y) search_line(column * grid.count(1) + inside(y, 1));
    }
  }
}

/// Pairs of two wide grains, sorted by their lower end along x. In a periodic box the first ones follow the last.
template <int D>
void WidePairs<D>::with_each_other(const Spots<D>& spots, const Box<D>& box) {
  double widest = 0.0;
  for (const auto k : wide_) widest = std::max(widest, spots.range[k] + travel_[k]);
  const auto& x = spots.at[0];
  std::sort(wide_.begin(), wide_.end(), [&](auto a, auto b) { return x[a] != x[b] ? x[a] < x[b] : a < b; });
  for (std::size_t k = 0; k < wide_.size(); ++k) {
    const auto i = wide_[k];
    const double until = x[i] + spots.range[i] + travel_[i] + widest;
    for (std::size_t n = k + 1; n < wide_.size() && x[wide_[n]] < until; ++n) add_if_near(i, wide_[n], spots, box);
    if (!box.periodic) continue;
    for (std::size_t n = 0; n < k && x[wide_[n]] + box.width() < until; ++n) {
      const bool met_before = x[i] < x[wide_[n]] + spots.range[wide_[n]] + travel_[wide_[n]] + widest;
      if (!met_before) add_if_near(i, wide_[n], spots, box);
    }
  }
}

template class WidePairs<2>;
template class WidePairs<3>;

}  // namespace repose
