// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/ordered_grains.hpp"
#include "repose/core/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The geometry of a packing. All arrays have one entry per disc, in order of deposition; base discs may stand
/// anywhere. Positions in a periodic box are wrapped.
struct Discs {
  std::vector<Vec<2>> position;    ///< [L] centres
  std::vector<double> radius;      ///< [L] > 0
  std::vector<std::uint8_t> base;  ///< 1: a base disc, which was not deposited

  std::size_t size() const { return position.size(); }
  void add(const Vec<2>& centre, double disc_radius, bool is_base = false) {
    position.push_back(centre);
    radius.push_back(disc_radius);
    base.push_back(is_base ? 1 : 0);
  }
};

/// The grains in their order, in which sources add them. A base disc is a grain flagged as base; whether it is fixed
/// does not matter, because some methods fix the grains that they deposit.
Discs discs_of(const OrderedGrains<2>& grains);

/// Number of deposited discs.
std::size_t deposited_count(const Discs& discs);

/// Mean diameter [L] of the deposited discs; NaN if there are none.
double mean_diameter(const Discs& discs);

}  // namespace repose
