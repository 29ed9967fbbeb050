// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <map>
#include <vector>

namespace repose {

/// Finds where on a level of one height there is room for another grain. One pass over all grains finds those near the
/// level; each question then concerns neighbours only.
template <int D>
class Room {
 public:
  /// For grains of up to `largest` radius [L] at `height` [L]; two grains keep `reach` times the sum of their radii.
  Room(const Grains<D>& grains, const Box<D>& box, double height, double largest, double reach);

  bool is_free(const Grain<D>& grain) const;

  /// Takes a grain in that has been put on the level.
  void add(const Grain<D>& grain);

 private:
  using Cell = std::array<long, D - 1>;

  Cell cell_of(const Vec<D>& place) const;
  void put(const Grain<D>& grain);

  Box<D> box_;
  double reach_;
  double cell_;  // [L] at least the distance that any two keep
  std::map<Cell, std::vector<Grain<D>>> cells_;
};

}  // namespace repose
