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

/// The surface of a packing seen from above, in columns of equal width between the sides of a box.
struct SurfaceProfile {
  double left = 0.0;           ///< [L] edge of the first column
  double column = 0.0;         ///< [L] width of a column
  bool periodic = false;       ///< the last column meets the first
  std::vector<double> height;  ///< [L] y of the highest point of any disc over the column; NaN where there is none

  double x(std::size_t k) const { return left + (static_cast<double>(k) + 0.5) * column; }
};

/// Profile of all discs (of the base too), in columns of about `column` [L] so that they fill the box. A disc that
/// reaches into a column by less than 1e-9 of its width does not count there.
SurfaceProfile surface_profile(const Discs& discs, const Box<2>& box, double column);

/// Root mean square [L] of the heights about their mean; columns without a disc are left out. NaN for none.
double roughness(const SurfaceProfile& profile);

/// Roughness within windows: w(l)^2 is the mean, over all places of a window of l, of the variance in it.
struct RoughnessScaling {
  std::vector<double> window;        ///< [L] l
  std::vector<double> width;         ///< [L] w(l)
  std::optional<Estimate> exponent;  ///< alpha of w ~ l^alpha: slope of log w against log l; none for < 3 windows
};

/// Windows of `windows` columns each (2 or more, at most all). Those that hold a column without a disc are left out.
/// The error of alpha is the jackknife over eight parts of the profile by where a window begins. A window that holds
/// the correlation length or more bends w(l) down; few columns bend it too (a Brownian profile has
/// w^2 = s^2 (l^2 - 1)/(6 l), s the step). Alpha above 1 reads as 1. Validated by tests/unit/surface_test.cpp.
RoughnessScaling roughness_scaling(const SurfaceProfile& profile, const std::vector<std::size_t>& windows);

/// Numbers of columns from 4 to a quarter of the profile, each about sqrt(2) times the one before.
std::vector<std::size_t> usual_windows(const SurfaceProfile& profile);

/// How the surface roughened while the discs were deposited.
struct SurfaceGrowth {
  std::vector<std::size_t> deposited;  ///< number of discs
  std::vector<double> mean_height;     ///< [L] mean y of the profile after them
  std::vector<double> width;           ///< [L] its roughness
  std::optional<Estimate> exponent;    ///< beta of w ~ n^beta: slope of log w against log n; none for < 3 numbers
};

/// The surface after each number of deposited discs in `deposited` (ascending; those beyond the last disc are left
/// out), in the order of the arrays; base discs are there from the start. One pass over the discs. The caller chooses
/// numbers before saturation. The error of beta is the jackknife over eight parts of the box.
SurfaceGrowth surface_growth(const Discs& discs, const Box<2>& box, double column,
                             const std::vector<std::size_t>& deposited);

/// About twelve numbers from one disc per column up to all, evenly spaced in their logarithm.
std::vector<std::size_t> usual_numbers(const Discs& discs, const Box<2>& box, double column);

}  // namespace repose
