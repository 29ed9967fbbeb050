// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/fields.hpp"
#include "repose/analysis/heap.hpp"

#include <optional>

namespace repose {

/// Densities and stresses of parts of a heap, by the coarse-grained fields. The half-width is half the distance between
/// the ends of the surface. The column below the apex is as wide as 0.3 half-widths, the flanks lie from 0.3 to 0.7
/// half-widths beside the apex; both from 0.1 of the height of the apex on, so that the base does not count.
struct HeapZones {
  double middle_solid_fraction = 0.0;  ///< below the apex, from 0.4 to 0.6 of its height
  double lower_solid_fraction = 0.0;   ///< below the apex, from 0.1 to 0.3 of its height
  /// Of the axis of the major principal stress of the flanks from the horizontal, mean over their pressure. Lines that
  /// lead outwards and down count as inclined by less than 90 degrees.
  double stress_inclination_deg = 0.0;
  double steeper_than_surface_deg = 0.0;  ///< the inclination less the mean angle of repose; NaN without one
};

/// None where a zone has no grains. Validated by tests/unit/heap_zones_test.cpp.
std::optional<HeapZones> heap_zones(const HeapShape& heap, const Fields& fields, double base_height);

}  // namespace repose
