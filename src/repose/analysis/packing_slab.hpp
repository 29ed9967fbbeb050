// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/box.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// The measured part of a packing, away from base and surface: low <= y < high and, in a box that is not periodic,
/// x_min <= x < x_max.
struct Slab {
  double low = 0.0;          ///< [L]
  double high = 0.0;         ///< [L]
  double base_height = 0.0;  ///< [L] y of the base centres
  double mean_height = 0.0;  ///< [L] ybar, mean height of the deposited centres above the base centres
  Box<2> box;                ///< its sides are side walls, or x wraps there

  double height() const { return high - low; }
  double area() const { return box.width() * height(); }
  bool holds(const Vec<2>& point) const {
    return point[1] >= low && point[1] < high && (box.periodic || (point[0] >= box.x_min && point[0] < box.x_max));
  }
};

struct SlabOptions {
  double low = 0.4;   ///< height of the lower edge above the base centres, divided by ybar
  double high = 1.4;  ///< height of the upper edge above the base centres, divided by ybar
  /// [L] y of the base centres; by default the mean over the base discs. A flat floor has none: give floor + radius,
  /// the height of the centre of a disc that rests on it.
  std::optional<double> base_height;
};

/// A slab, or one sentence why there is none.
struct SlabResult {
  std::optional<Slab> slab;
  std::string problem;
};

/// The slab [low ybar, high ybar] above the base centres. There is none if nothing was deposited, a disc has no finite
/// position or no positive radius, the box is infinitely wide, or no deposited centre lies in the slab. The limits are
/// a choice of Repose (docs/physics/deposition.md): paper one (Bratberg, Radjai, Hansen, PRE 66, 031303, 2002)
/// does not state its own.
SlabResult find_slab(const Discs& discs, const Box<2>& box, const SlabOptions& options = {});

/// Indices of the deposited discs with their centre in the slab, ascending.
std::vector<std::uint32_t> centres_in(const Discs& discs, const Slab& slab);

/// Index of the block that contains x [L], if the slab is cut along x into `count` blocks of equal width.
inline std::size_t block_of(const Slab& slab, double x, std::size_t count) {
  const double place = (x - slab.box.x_min) / slab.box.width() * static_cast<double>(count);
  return std::min(count - 1, static_cast<std::size_t>(std::max(0.0, place)));
}

/// A statistic of sums over the blocks of a slab, and its standard error by the jackknife over blocks. Structures that
/// cross the edges correlate the blocks, so the error of a single packing is only a guide; use an ensemble for
/// verdicts.
template <std::size_t N, class Statistic>
Estimate over_blocks(const std::vector<std::array<double, N>>& blocks, const Statistic& statistic) {
  return jackknife(blocks.size(), [&](std::size_t without) {
    std::array<double, N> sums{};
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (b == without) continue;
      for (std::size_t k = 0; k < N; ++k) sums[k] += blocks[b][k];
    }
    return static_cast<double>(statistic(sums));
  });
}

}  // namespace repose
