// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/heap.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/grains.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// One ring of the surface of a conical heap.
struct ConeRing {
  static constexpr std::size_t sectors = 8;

  double radius = 0.0;                          ///< [L] from the axis to the middle of the ring
  double height = 0.0;                          ///< [L] above the base, mean over the azimuth
  std::array<double, sectors> sector_height{};  ///< [L] mean over each sector; NaN without a grain
  bool used = false;                            ///< whether the line of the mean surface is fitted to it
};

/// The shape of a conical heap.
struct ConicalHeap {
  Vec<2> axis{};                  ///< [L] x, y
  double apex_height = 0.0;       ///< [L] of the highest grain top above the base
  std::vector<ConeRing> surface;  ///< from the axis outwards; empty without a heap
  /// Through the mean surface, against the radius. Neither lines nor angles exist unless the surface falls below half
  /// the height of the apex in all sectors: a bed, however rough, has none.
  std::optional<FlankLine> line;
  /// Sector k reaches from 45 k to 45 (k + 1) degrees of azimuth, from x to y.
  std::array<std::optional<FlankLine>, ConeRing::sectors> sector_lines{};
  Estimate angle_deg;  ///< [deg] angle of repose over the sectors: mean, deviation and standard error of the mean
  /// atan(2 <z>/<r>), exact for a cone of uniform density.
  std::optional<double> moments_angle_deg;
};

/// Measures a conical heap about an upright axis, by default through the centre of mass of the grains flagged
/// `in_heap`.
///
/// The surface is sampled in rings `ring_width` [L] wide, cut along the azimuth into patches about as long as they are
/// wide, a whole number in each of eight sectors. The height of a patch is that of the highest grain top in it above
/// `base_height` [L]; heights of rings and sectors are means over their patches with grains. So the size of a patch, on
/// which a highest top depends, is the same at all radii beyond two ring widths. The surface ends before the first ring
/// without a grain. Lines are least-squares lines through rings between 10 % and 90 % of the height of the apex,
/// without the innermost ring.
///
/// The estimate by moments: a uniform cone of height H and radius R has <z> = H/4 and <r> = R/2, so that H/R =
/// 2 <z>/<r>; means are over mass. An axis that is off by e increases <r> by 3 e^2/(4 R).
/// Validated by tests/unit/cone_shape_test.cpp.
ConicalHeap measure_cone(const Grains<3>& grains, const std::vector<bool>& in_heap, double base_height,
                         double ring_width, const std::optional<Vec<2>>& axis = std::nullopt);

/// The depth [L] below the surface of a point at distance `radius` from the axis and at `height` above the base,
/// perpendicular to the mean line; negative above the surface. The surface is linear between the middles of its rings
/// and level within the innermost and beyond the outermost.
double depth_below_surface(const ConicalHeap& cone, double radius, double height);

}  // namespace repose
