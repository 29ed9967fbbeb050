// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/neighbours/cell_grid.hpp"
#include "repose/neighbours/spots.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The pairs that a search in neighbouring cells does not find: those of grains much larger than most, and those that
/// the motion of a fast grain may bring together before the next search.
template <int D>
class WidePairs {
 public:
  struct Pair {
    std::uint32_t low;
    std::uint32_t high;
  };

  /// Finds them. `allowance` [L] is what each grain may move, of which `slow` is part of its range; `grid` has the
  /// spots in its order.
  void find(const Spots<D>& spots, const std::vector<double>& allowance, double slow, const CellGrid<D>& grid,
            const Box<D>& box);

  void clear() { pairs_.clear(); }

  /// Ascending by low, then high; each once.
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  void with_cells(std::uint32_t i, const Spots<D>& spots, const CellGrid<D>& grid, const Box<D>& box);
  void with_each_other(const Spots<D>& spots, const Box<D>& box);
  void add_if_near(std::uint32_t i, std::uint32_t j, const Spots<D>& spots, const Box<D>& box);

  std::vector<double> travel_;       // [L] what each grain may move beyond its range
  std::vector<std::uint32_t> wide_;  // large or fast grains
  std::vector<Pair> pairs_;
};

}  // namespace repose
