// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/discs.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/box.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// The upper surface of a packing, in columns of equal width between the sides of a box.
struct SurfaceProfile {
  double left = 0.0;           ///< [L] left edge of the first column
  double column = 0.0;         ///< [L] width of a column
  bool periodic = false;       ///< whether the last column meets the first
  std::vector<double> height;  ///< [L] y of the highest point of any disc in the column; NaN without a disc

  double x(std::size_t k) const { return left + (static_cast<double>(k) + 0.5) * column; }
};

/// The profile of all discs, base discs included, in columns of about `column` [L] that fill the box. A disc that
/// reaches into a column by less than 1e-9 of its width does not count there.
SurfaceProfile surface_profile(const Discs& discs, const Box<2>& box, double column);

/// Root mean square deviation [L] of the heights from their mean. Columns without a disc are left out; NaN without any.
double roughness(const SurfaceProfile& profile);

/// Roughness within windows: w(l)^2 is the mean, over all positions of a window of length l, of the variance in it.
struct RoughnessScaling {
  std::vector<double> window;        ///< [L] l
  std::vector<double> width;         ///< [L] w(l)
  std::optional<Estimate> exponent;  ///< alpha of w ~ l^alpha: slope of log w against log l; none for < 3 windows
};

/// Measures the roughness within windows of `windows` columns each (from 2 to all). Windows with a column without a
/// disc are left out. The error of alpha is the jackknife over eight parts of the profile, by the start of a window.
/// Windows longer than the correlation length bend w(l) down, and so do windows of few columns (a Brownian profile has
/// w^2 = s^2 (l^2 - 1)/(6 l), s the step). An alpha above 1 is measured as 1.
/// Validated by tests/unit/surface_test.cpp.
RoughnessScaling roughness_scaling(const SurfaceProfile& profile, const std::vector<std::size_t>& windows);

/// Numbers of columns from 4 to a quarter of the profile, each about sqrt(2) times the previous one.
std::vector<std::size_t> usual_windows(const SurfaceProfile& profile);

/// The roughness of the surface during the deposition.
struct SurfaceGrowth {
  std::vector<std::size_t> deposited;  ///< number of discs
  std::vector<double> mean_height;     ///< [L] mean y of the profile after that number
  std::vector<double> width;           ///< [L] its roughness
  std::optional<Estimate> exponent;    ///< beta of w ~ n^beta: slope of log w against log n; none for < 3 numbers
};

/// Measures the surface after each number of discs in `deposited` (ascending; numbers above the count are left out).
/// Discs are deposited in the order of the arrays, and base discs are present from the start. Beta is meaningful only
/// for numbers before saturation, which the caller chooses. Its error is the jackknife over eight parts of the box.
/// Cost: one pass over the discs.
SurfaceGrowth surface_growth(const Discs& discs, const Box<2>& box, double column,
                             const std::vector<std::size_t>& deposited);

/// About twelve numbers from one disc per column up to all discs, evenly spaced in their logarithm.
std::vector<std::size_t> usual_numbers(const Discs& discs, const Box<2>& box, double column);

}  // namespace repose
