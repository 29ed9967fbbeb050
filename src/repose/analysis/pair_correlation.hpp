// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/packing_slab.hpp"

#include <cstddef>
#include <vector>

namespace repose {

struct PairCorrelationOptions {
  double reach = 0.0;      ///< [mean diameters] largest distance; 0: 8, or less where the slab does not hold it
  double bin_width = 0.1;  ///< [mean diameters] > 0
  double strip = 0.25;     ///< [mean diameters] half-width of the strips for the correlations along x and y
};

/// A correlation in bins of distance: 1 where the places of two discs do not depend on each other.
struct Correlation {
  std::vector<double> distance;    ///< [L] centres of the bins
  std::vector<std::size_t> pairs;  ///< pairs of discs in each bin
  std::vector<double> value;       ///< pairs over those expected of points without correlation; NaN where none can be
  std::vector<double> error;       ///< value over the square root of the pairs (of one pair where there is none)
};

/// Density-density correlation G(r) = <rho(0) rho(r)> of the centres, over the squared density, without the disc itself
/// at r = 0 (thesis, equation 7), in three readings.
struct PairCorrelation {
  Correlation radial;   ///< g(r), averaged over directions
  Correlation along_x;  ///< of |dx| where |dy| < strip
  Correlation along_y;  ///< of |dy| where |dx| < strip
};

/// Pairs of deposited discs with both centres in the slab. What is expected at a distance is exact for uniform points:
/// around each disc the area of the part of the ring that lies in the slab (closed form), times the density of the
/// others, (N - 1)/area; along x and y the share of the slab that stays in it when moved by (dx, dy). A radial reach is
/// at most half the width of a periodic box, so that images do not meet. A gradient of density shows as a value
/// above 1. Errors take pairs as independent, which holds without correlation. Empty for fewer than two discs. Cost:
/// the pairs within reach. Validated by tests/unit/pair_correlation_test.cpp.
PairCorrelation pair_correlation(const Discs& discs, const Slab& slab, const PairCorrelationOptions& options = {});

}  // namespace repose
