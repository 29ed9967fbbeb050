// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/heap.hpp"
#include "repose/analysis/voronoi.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <optional>
#include <vector>

namespace repose {

/// The inside of a heap, away from the layer that avalanches move and from the order that the base imposes.
struct CoreRegion {
  std::size_t grains = 0;
  std::optional<double> solid_fraction;  ///< disc area over area of the Voronoi cells
  std::optional<double> coordination;    ///< mean number of contacts above the threshold
};

/// The core: grains of the heap with closed cells whose centres lie at least `depth` [L] below the surface (at right
/// angles to the flank on their side) and at least `above_base` [L] above the base centres. `threshold` [M L/T^2] is
/// for the normal force of a contact that counts.
CoreRegion measure_core(const Grains<2>& grains, const Contacts<2>& contacts, const HeapShape& heap,
                        const std::vector<VoronoiCell>& cells, double base_height, double depth, double above_base,
                        double threshold);

}  // namespace repose
