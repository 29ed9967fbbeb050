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

/// The core of a heap: away from the layer that avalanches move and from the order that the base imposes.
struct CoreRegion {
  std::size_t grains = 0;
  std::optional<double> solid_fraction;  ///< area of the discs divided by that of their Voronoi cells
  std::optional<double> coordination;    ///< mean number of contacts above the threshold
};

/// Measures the core. It consists of the grains of the heap that have closed cells and whose centres lie at least
/// `depth` [L] below the surface (perpendicular to the flank on their side) and at least `above_base` [L] above the
/// base centres. Contacts with a normal force, push or pull, above `threshold` [M L/T^2] count.
CoreRegion measure_core(const Grains<2>& grains, const Contacts<2>& contacts, const HeapShape& heap,
                        const std::vector<VoronoiCell>& cells, double base_height, double depth, double above_base,
                        double threshold);

}  // namespace repose
