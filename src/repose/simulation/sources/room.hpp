// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <unordered_map>
#include <vector>

namespace repose {

/// Tells where along a line of one height there is room for another grain. One pass over all grains finds those near
/// the line; each question then concerns neighbours only.
class Room {
 public:
  /// For grains of up to `largest` radius [L] at `height` [L]; two grains keep `reach` times the sum of their radii.
  Room(const Grains<2>& grains, const Box<2>& box, double height, double largest, double reach);

  bool is_free(const Grain<2>& grain) const;

  /// Takes a grain in that has been put on the line.
  void add(const Grain<2>& grain);

 private:
  long cell_of(double x) const;
  void put(const Grain<2>& grain);

  Box<2> box_;
  double reach_;
  double cell_;  // [L] at least the distance that any two keep
  std::unordered_map<long, std::vector<Grain<2>>> cells_;
};

}  // namespace repose
