// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/core/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace repose {

inline Box<2> sides(double width, bool periodic = true) {
  Box<2> box;
  box.periodic = periodic;
  box.x_min = 0.0;
  box.x_max = width;
  return box;
}

inline Slab slab_between(double low, double high, const Box<2>& box) {
  Slab slab;
  slab.low = low;
  slab.high = high;
  slab.mean_height = high - low;
  slab.box = box;
  return slab;
}

/// A sequence of random numbers in [0, 1).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed) {}
  double operator()() { return uniform(seed_, Purpose::lattice_place, index_++); }
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - (*this)()));
    return radius * std::cos(2.0 * std::numbers::pi * (*this)());
  }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

/// Discs of diameter 1 in rows `rise` apart, every second row moved by `shift`; the lowest row, at y = 0, is the base.
inline Discs rows_of_discs(int columns, int rows, double rise, double shift) {
  Discs discs;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < columns; ++k) discs.add({{k + (row % 2) * shift, row * rise}}, 0.5, row == 0);
  }
  return discs;
}
inline Discs triangular_packing(int columns, int rows) { return rows_of_discs(columns, rows, std::sqrt(0.75), 0.5); }
inline Discs square_packing(int columns, int rows) { return rows_of_discs(columns, rows, 1.0, 0.0); }

/// Independent random positions, as centres of discs of diameter 1 that may overlap.
inline Discs independent_discs(std::size_t count, const Slab& slab, std::uint64_t seed) {
  Draw draw(seed);
  Discs discs;
  while (discs.size() < count) {
    const double x = slab.box.x_min + draw() * slab.box.width();
    discs.add({{x, slab.low + draw() * slab.height()}}, 0.5);
  }
  return discs;
}

/// Discs of diameter 1 that fall along vertical lines at random x and stick at the first touch (critical angle 90
/// degrees), on a base of touching discs; x is periodic. By brute force.
inline Discs sticking_packing(int columns, std::size_t deposited, std::uint64_t seed) {
  Draw draw(seed);
  Discs discs;
  for (int k = 0; k < columns; ++k) discs.add({{k + 0.5, 0.0}}, 0.5, true);
  const auto box = sides(columns);
  for (std::size_t n = 0; n < deposited; ++n) {
    const double x = draw() * columns;
    double y = 0.0;
    for (const auto& below : discs.position) {
      const double aside = separation(Vec<2>{{x, 0.0}}, Vec<2>{{below[0], 0.0}}, box)[0];
      if (std::fabs(aside) < 1.0) y = std::max(y, below[1] + std::sqrt(1.0 - aside * aside));
    }
    discs.add({{x, y}}, 0.5);
  }
  return discs;
}

}  // namespace repose
