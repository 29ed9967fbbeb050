// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/ordered_grains.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The geometry of a packing of discs or spheres. All arrays have one entry per grain, in order of deposition; base
/// grains may stand anywhere. Positions in a periodic box are wrapped.
template <int D>
struct Balls {
  std::vector<Vec<D>> position;    ///< [L] centres
  std::vector<double> radius;      ///< [L] > 0
  std::vector<std::uint8_t> base;  ///< 1: a base grain, which was not deposited

  std::size_t size() const { return position.size(); }
  void add(const Vec<D>& centre, double ball_radius, bool is_base = false) {
    position.push_back(centre);
    radius.push_back(ball_radius);
    base.push_back(is_base ? 1 : 0);
  }
};
using Discs = Balls<2>;
using Spheres = Balls<3>;

/// The grains in their order, in which sources add them. A base disc is a grain flagged as base; whether it is fixed
/// does not matter, because some methods fix the grains that they deposit.
Discs discs_of(const OrderedGrains<2>& grains);
Spheres spheres_of(const OrderedGrains<3>& grains);

/// Number of deposited discs or spheres.
template <int D>
std::size_t deposited_count(const Balls<D>& balls);

/// Mean diameter [L] of the deposited discs or spheres; NaN if there are none.
template <int D>
double mean_diameter(const Balls<D>& balls);

}  // namespace repose
