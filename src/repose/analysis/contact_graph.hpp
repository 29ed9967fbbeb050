// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/core/box.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace repose {

/// The pairs of discs or spheres that touch, by geometry alone.
struct ContactGraph {
  std::vector<std::uint32_t> start;      ///< (n + 1) first neighbour of each disc
  std::vector<std::uint32_t> neighbour;  ///< ascending for each disc; every contact is listed for both its discs

  std::size_t contacts() const { return neighbour.size() / 2; }
  std::size_t degree(std::size_t disc) const { return start[disc + 1] - start[disc]; }
  std::span<const std::uint32_t> of(std::size_t disc) const {
    return {neighbour.data() + start[disc], neighbour.data() + start[disc + 1]};
  }
};

/// Whether two grains touch: the gap between them, by the nearest image, is less than `gap` times their mean diameter.
/// Overlapping grains touch.
template <int D>
bool touch(const Balls<D>& balls, const Box<D>& box, double gap, std::size_t i, std::size_t j) {
  const double reach = (balls.radius[i] + balls.radius[j]) * (1.0 + gap);
  return squared(separation(balls.position[i], balls.position[j], box)) < reach * reach;
}

/// All contacts with a gap less than `gap` >= 0 mean diameters of the pair. A pair counts once, so a periodic box must
/// be wider than two of the largest diameters. Cost: linear in the number of grains. The result equals that of a search
/// over all pairs, to the bit (tests/unit/contact_graph_test.cpp, tests/unit/sphere_packing_test.cpp).
template <int D>
ContactGraph contact_graph(const Balls<D>& balls, const Box<D>& box, double gap);

/// The walls of a packing. They count as neighbours of the grains that touch them.
struct PackingWalls {
  std::optional<double> floor;  ///< [L] height of the floor
  std::optional<double> left;   ///< [L] x of the left wall
  std::optional<double> right;  ///< [L] x of the right wall
  // In three dimensions alone.
  std::optional<double> front{};  ///< [L] y of the front wall, at the lower y
  std::optional<double> back{};   ///< [L] y of the back wall
};

/// For every grain, the number of walls nearer to its rim than `gap` times its diameter.
template <int D>
std::vector<std::uint8_t> wall_contacts(const Balls<D>& balls, const PackingWalls& walls, double gap);

/// One flag per grain, 1 for a rattler. Rattlers are the deposited grains with fewer than `least` contacts, where
/// contacts with rattlers do not count and contacts with walls do; they are removed repeatedly until none is left. Base
/// discs are never rattlers. A disc without rolling friction needs two contacts to rest. A disc held by rolling
/// friction needs only one, so a packing made by sticking alone (critical angle 90 degrees: a forest of trees) consists
/// of rattlers. A sphere without rolling friction needs three contacts.
template <int D>
std::vector<std::uint8_t> rattlers(const Balls<D>& balls, const ContactGraph& graph,
                                   const std::vector<std::uint8_t>& on_walls, std::size_t least = D);

}  // namespace repose
