// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/methods/method.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>

namespace repose {

/// A sphere to be dropped.
struct DroppedSphere {
  /// Each in [0, 1): relative position between the sides along x and y. Over a disc-shaped area, the first is the
  /// fraction of the area that lies nearer to its centre, and the second the direction in turns.
  std::array<double, 2> place{};
  double radius = 0.0;  ///< [L]
  double mass = 0.0;    ///< [M]
  std::uint16_t material = 0;
};

/// The settings of the method `deposition` for spheres.
struct SphereDepositionSettings {
  double critical_angle_deg = 50.0;  ///< in [0, 90]: a sphere sticks where its way down slopes by less than this
  /// x and y are periodic, with widths of at least two largest diameters, or bounded by smooth upright walls, or open
  /// where a bound is infinite.
  Box<3> box;
  double floor = -std::numeric_limits<double>::infinity();  ///< [L] z of a flat floor, on which every sphere stops
  /// [L] radius of a disc-shaped area over which spheres drop uniformly; infinite: over the whole box
  double drop_radius = std::numeric_limits<double>::infinity();
  std::array<double, 2> drop_centre{};  ///< [L] (x, y) of its centre
  double largest_radius = 0.5;          ///< [L] largest of all spheres, base included, > 0
  /// Whether positions are multiples of 2^-40 of the largest radius, so that rounding does not grow from layer to
  /// layer.
  bool snapped = false;
  std::int64_t count = 0;  ///< number of spheres to drop
  /// Fills `spheres` with the k-th sphere and those that follow. Each is a function of its number alone.
  std::function<void(std::int64_t k, std::span<DroppedSphere> spheres)> draw;
};

/// The method `deposition` for spheres, which is geometry alone. One step drops one sphere by the critical-angle rule
/// (spheres_roller.hpp) onto those deposited before; time counts spheres. A sphere that falls beside an open base is
/// lost: it counts as made and is not added. With periodic or walled sides and nothing below, a fall without end is
/// trouble. The method is sequential and uses one thread. Contacts are those at which each sphere came to rest, three
/// at most, without forces. Validated by tests/unit/deposition_spheres_test.cpp and
/// tests/unit/deposition_spheres_packing_test.cpp.
std::unique_ptr<Method<3>> make_sphere_deposition(const SphereDepositionSettings& settings);

/// The same method with a search over every sphere: slow, the reference for tests.
std::unique_ptr<Method<3>> make_sphere_deposition_by_brute_force(const SphereDepositionSettings& settings);

}  // namespace repose
