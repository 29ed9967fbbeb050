// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose {

/// What the search for pairs knows of each grain, in arrays that it reads one after the other.
template <int D>
struct Spots {
  std::array<std::vector<double>, D> at;  ///< [L] coordinates
  std::vector<double> range;              ///< [L] two grains are near if closer than the sum of their ranges
  std::vector<std::uint8_t> fixed;        ///< 1: pairs with other fixed grains do not count
  double cell_range = 0.0;                ///< [L] largest range of the grains that one cell of the grid reaches

  void resize(std::size_t count) {
    for (auto& axis : at) axis.resize(count);
    range.resize(count);
    fixed.resize(count);
  }
  std::size_t size() const { return range.size(); }

  /// Whether the range of a grain is too long for the cells. Such large grains are searched for apart.
  bool large(std::size_t k) const { return range[k] > cell_range; }

  /// Squared distance [L^2] by the nearest image.
  double distance2(std::size_t i, std::size_t j, const Box<D>& box) const {
    Vec<D> a;
    Vec<D> b;
    for (std::size_t axis = 0; axis < D; ++axis) {
      a[static_cast<int>(axis)] = at[axis][i];
      b[static_cast<int>(axis)] = at[axis][j];
    }
    const Vec<D> d = separation(a, b, box);
    return dot(d, d);
  }
  bool both_fixed(std::size_t i, std::size_t j) const { return (fixed[i] & fixed[j]) != 0; }
};

}  // namespace repose
