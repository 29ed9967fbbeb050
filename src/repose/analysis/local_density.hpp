// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"
#include "repose/analysis/statistics.hpp"

#include <cstddef>
#include <vector>

namespace repose {

/// Local solid fractions of the deposited discs with their centre in a slab. The local solid fraction is the area of a
/// disc divided by that of its Voronoi cell.
struct LocalDensity {
  std::size_t cells = 0;            ///< number of closed cells
  std::size_t open = 0;             ///< number of cells left out: they end at the cut-off, or are empty
  Estimate density;                 ///< over closed cells; the error takes them as independent
  double solid_fraction = 0.0;      ///< area of the discs divided by that of the closed cells
  double bin_width = 0.0;           ///< of the histogram
  std::vector<double> centre;       ///< centres of the bins, which cover [0, 1]
  std::vector<std::size_t> count;   ///< cells in each bin
  std::vector<double> probability;  ///< probability density of the local solid fraction; its sum times bin_width is 1
};

/// Measures local solid fractions. For equal discs, the mean of the cell areas divided by the disc area is the inverse
/// of `solid_fraction`. `solid_fraction` differs from the solid fraction of the slab only by cells that the edges of
/// the slab cut and by large voids, where cells are open. Cells are cut off at 1.5 largest diameters, and those that
/// end there at 6 in a second pass. Side walls of a box that is not periodic bound cells. Cost: 2 to 6 microseconds per
/// disc, more in loose packings.
LocalDensity local_density(const Discs& discs, const Slab& slab, std::size_t bins);

}  // namespace repose
