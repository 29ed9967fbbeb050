// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/ordered_grains.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace repose {

/// A force of the heap on the base, at one place.
struct BaseLoad {
  Vec<2> place{};  ///< [L] x, y
  Vec<3> force{};  ///< [M L/T^2] on the base
};

/// The forces of moving grains on the base grains, one for each base grain by ascending id, loaded or not, at its
/// centre.
std::vector<BaseLoad> loads_on_base_grains(const OrderedGrains<3>& grains, const Contacts<3>& contacts);

/// The forces of moving grains on walls, one for each contact in the order of the list, at the contact point. `walls`
/// has an entry for each wall: whether it is one of them.
std::vector<BaseLoad> loads_on_walls(const OrderedGrains<3>& grains, const Contacts<3>& contacts,
                                     const std::vector<bool>& walls);

struct BaseRingSettings {
  Vec<2> axis{};            ///< [L] x, y
  double width = 0.0;       ///< [L] > 0, of a ring
  std::size_t sectors = 8;  ///< >= 2, over which errors are estimated
  /// [L^2] The area of the base that belongs to one load. Without it the area of a part of a ring is that of its
  /// outline, right for the contacts on a wall. For base grains it is their number times this area, so that a lattice
  /// does not put noise on the pressure of small rings.
  std::optional<double> area_of_load{};
};

/// The loads in one ring.
struct BaseRing {
  double inner = 0.0;           ///< [L]
  double outer = 0.0;           ///< [L]
  std::size_t count = 0;        ///< loads in it
  double area = 0.0;            ///< [L^2]
  double pressure = 0.0;        ///< [M/(L T^2)] normal force per area, positive downwards; NaN without area
  double pressure_error = 0.0;  ///< [M/(L T^2)] standard error, jackknife over the sectors
  double shear = 0.0;           ///< [M/(L T^2)] radial force per area, positive outwards
  double shear_error = 0.0;     ///< [M/(L T^2)]
  double cumulative = 0.0;      ///< [M L/T^2] normal force within the outer radius
};

/// The pressure of a conical heap on its base.
struct BaseRings {
  std::vector<BaseRing> rings;          ///< from the axis outwards, contiguous up to the outermost load
  double load = 0.0;                    ///< [M L/T^2] the sum of all normal forces
  std::optional<double> loaded_radius;  ///< [L] see loaded_radius
  std::optional<Estimate> dip_index;    ///< see dip_index; the error is the jackknife over the sectors
};

/// The part of the load that the loaded radius holds: that within 0.9 radii of a full cone, 3 x^2 - 2 x^3 at x = 0.9.
inline constexpr double part_in_loaded_radius = 0.972;

/// The radius [L] about the axis that holds 97.2 % of the load. The pressure of a full cone, p (1 - r/R), has fallen to
/// a tenth of its largest value there, as at the edge of the loaded width in 2D (base_dip). As an integral it depends
/// neither on the noise of a small central ring nor on the width of rings. A plateau that ends at R gives
/// sqrt(0.972) R = 0.986 R. None without load.
std::optional<double> loaded_radius(const std::vector<BaseLoad>& loads, const Vec<2>& axis);

/// The dip index: mean pressure at 0.15 to 0.45 loaded radii from the axis, divided by that within 0.15. It is 1 for a
/// plateau and above 1 for a dip; a full cone over its true radius R gives 2.025/2.7 = 0.75, and over its loaded
/// radius, 0.9 R, 2.1225/2.73 = 0.777. None without area or load in one of the two ranges.
std::optional<Estimate> dip_index(const std::vector<BaseLoad>& loads, const BaseRingSettings& settings,
                                  double loaded_radius);

/// Measures the loads in rings of equal width about the axis. Errors are the jackknife over sectors of the azimuth,
/// from x to y; for parts of equal area they are s/sqrt(n) of the pressures of the n sectors. Forces of one time are
/// correlated through chains, a grain or two long at the base, so a ring should be wider than a grain.
/// Validated by tests/unit/base_rings_test.cpp.
BaseRings measure_base_rings(const std::vector<BaseLoad>& loads, const BaseRingSettings& settings);

}  // namespace repose
