// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <functional>
#include <limits>

namespace repose {

/// A disc about to be dropped.
struct DroppedDisc {
  double place = 0.0;  ///< in [0, 1): where between the sides
  Grain<2> grain;      ///< its radius and masses
  std::uint16_t material = 0;
};

/// How discs are deposited one by one, and on what.
struct DepositionSettings {
  double critical_angle_deg = 50.0;  ///< in [0, 90]: a disc sticks to one whose contact is less than this off upright
  Box<2> box;                        ///< x periodic, or between two smooth walls at its sides
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] y of a flat floor, on which every disc stops
  double smallest_radius = 0.5;                             ///< [L] of all discs, base included, > 0
  double largest_radius = 0.5;                              ///< [L]
  bool snapped =
      false;  ///< places are multiples of 2^-40 of the largest radius: rounding cannot grow from layer to layer
  std::int64_t count = 0;                         ///< discs to deposit
  std::function<DroppedDisc(std::int64_t)> drop;  ///< the k-th of them, a function of k alone
};

}  // namespace repose
