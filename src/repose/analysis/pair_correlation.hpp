// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"

#include <cstddef>
#include <vector>

namespace repose {

struct PairCorrelationOptions {
  double reach = 0.0;      ///< [mean diameters] largest distance; 0 means 8, or the height of the slab if less
  double bin_width = 0.1;  ///< [mean diameters] > 0
  double strip = 0.25;     ///< [mean diameters] half-width of the strips for the correlations along x and y
};

/// A correlation in bins of distance; 1 for independent positions. Bins begin a thousandth of the mean diameter (at
/// most a tenth of a bin) below multiples of their width, so that discs in contact lie within one bin.
struct Correlation {
  std::vector<double> distance;    ///< [L] centres of the bins
  std::vector<std::size_t> pairs;  ///< pairs of discs in each bin
  std::vector<double> value;       ///< pairs divided by the number expected for independent points; NaN if that is 0
  std::vector<double> error;       ///< square root of the number of pairs (at least 1), divided by that number
};

/// Three forms of the density-density correlation G(r) = <rho(0) rho(r)> of the centres, divided by the squared
/// density, without the disc itself at r = 0 (thesis, equation 7).
struct PairCorrelation {
  Correlation radial;   ///< g(r), averaged over directions
  Correlation along_x;  ///< against |dx|, for pairs with |dy| < strip
  Correlation along_y;  ///< against |dy|, for pairs with |dx| < strip
};

/// Measures the correlations of the deposited discs with both centres in the slab. The expected number of pairs is
/// exact for uniform points. For g(r) it is the area, within the slab, of the ring around each disc (closed form) times
/// the density of the other discs, (N - 1)/area. Along x and y it follows from the fraction of the slab that stays in
/// it when shifted by (dx, dy). The reach is at most half the width of a periodic box, so that images do not meet. A
/// density gradient increases the values above 1. Errors take pairs as independent, which holds without correlation.
/// Empty for fewer than two discs. Cost: proportional to the number of pairs within reach.
/// Validated by tests/unit/pair_correlation_test.cpp.
PairCorrelation pair_correlation(const Discs& discs, const Slab& slab, const PairCorrelationOptions& options = {});

}  // namespace repose
