// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace repose {

/// A disc to be dropped.
struct DroppedDisc {
  double place = 0.0;   ///< in [0, 1): relative position between the sides
  double radius = 0.0;  ///< [L]
  double mass = 0.0;    ///< [M]
  std::uint16_t material = 0;
};

/// The settings of the method `deposition`.
struct DepositionSettings {
  double critical_angle_deg = 50.0;  ///< in [0, 90]: a disc sticks if its contact is less than this from the vertical
  Box<2> box;                        ///< x is periodic, or bounded by two smooth side walls
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] y of a flat floor, on which every disc stops
  double smallest_radius = 0.5;                             ///< [L] smallest of all discs, base included, > 0
  double largest_radius = 0.5;                              ///< [L] largest of all discs, base included
  /// Whether positions are multiples of 2^-40 of the largest radius, so that rounding does not grow from layer to
  /// layer.
  bool snapped = false;
  std::int64_t count = 0;  ///< number of discs to deposit
  /// Fills `discs` with the k-th disc and those that follow. Each is a function of its number alone.
  std::function<void(std::int64_t k, std::span<DroppedDisc> discs)> draw;
};

}  // namespace repose
