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

/// The pairs of discs that touch, by geometry alone.
struct ContactGraph {
  std::vector<std::uint32_t> start;      ///< (n + 1) first neighbour of each disc
  std::vector<std::uint32_t> neighbour;  ///< ascending for each disc; every contact is listed for both its discs

  std::size_t contacts() const { return neighbour.size() / 2; }
  std::size_t degree(std::size_t disc) const { return start[disc + 1] - start[disc]; }
  std::span<const std::uint32_t> of(std::size_t disc) const {
    return {neighbour.data() + start[disc], neighbour.data() + start[disc + 1]};
  }
};

/// Whether two discs touch: the gap between them, by the nearest image, is less than `gap` times their mean diameter.
/// Overlapping discs touch.
inline bool touch(const Discs& discs, const Box<2>& box, double gap, std::size_t i, std::size_t j) {
  const double reach = (discs.radius[i] + discs.radius[j]) * (1.0 + gap);
  return squared(separation(discs.position[i], discs.position[j], box)) < reach * reach;
}

/// All contacts with a gap less than `gap` >= 0 mean diameters of the pair. A pair counts once, so a periodic box must
/// be wider than two of the largest diameters. Cost: linear in the number of discs. The result equals that of a search
/// over all pairs, to the bit (tests/unit/contact_graph_test.cpp).
ContactGraph contact_graph(const Discs& discs, const Box<2>& box, double gap);

/// The walls of a packing. They count as neighbours of the discs that touch them.
struct PackingWalls {
  std::optional<double> floor;  ///< [L] y of the floor
  std::optional<double> left;   ///< [L] x of the left wall
  std::optional<double> right;  ///< [L] x of the right wall
};

/// For every disc, the number of walls nearer to its rim than `gap` times its diameter.
std::vector<std::uint8_t> wall_contacts(const Discs& discs, const PackingWalls& walls, double gap);

/// One flag per disc, 1 for a rattler. Rattlers are the deposited discs with fewer than `least` contacts, where
/// contacts with rattlers do not count and contacts with walls do; they are removed repeatedly until none is left. Base
/// discs are never rattlers. A disc without rolling friction needs two contacts to rest. A disc held by rolling
/// friction needs only one, so a packing made by sticking alone (critical angle 90 degrees: a forest of trees) consists
/// of rattlers.
std::vector<std::uint8_t> rattlers(const Discs& discs, const ContactGraph& graph,
                                   const std::vector<std::uint8_t>& on_walls, std::size_t least = 2);

}  // namespace repose
