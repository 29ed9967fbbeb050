// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/sphere_cells.hpp"
#include "repose/analysis/statistics.hpp"
#include "repose/core/box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace repose {

/// The measured part of a packing of spheres: between two levels, and within a distance of an upright axis.
struct PackingCore {
  double low = 0.0;                                         ///< [L] height of the lower edge
  double high = 0.0;                                        ///< [L] height of the upper edge
  Vec<2> axis{};                                            ///< [L] x, y
  double radius = std::numeric_limits<double>::infinity();  ///< [L]

  bool holds(const Vec<3>& point) const {
    return point[2] >= low && point[2] < high && magnitude(Vec<2>{{point[0], point[1]}} - axis) < radius;
  }
};

/// The core of a packing with the same edges as the slab in 2D: 0.4 and 1.4 mean heights of the deposited centres above
/// the base centres. `base_height` [L] is that of the base centres, or of the centre of a sphere that rests on a floor.
PackingCore usual_core(const Spheres& spheres, double base_height);

/// The measures of the deposited spheres with their centre in the core. All their neighbours count: in the core or
/// outside, base spheres and walls.
struct SpherePacking {
  std::size_t spheres = 0;
  std::size_t closed = 0;                                   ///< those of them with a closed cell
  Estimate solid_fraction;                                  ///< volume of these divided by that of their cells
  Estimate coordination;                                    ///< z, the mean number of contacts
  std::array<double, most_contacts<3> + 1> connectivity{};  ///< fraction with 0, 1, ... 11 contacts, and 12 or more
  double rattlers = 0.0;                                    ///< fraction that are rattlers
  Estimate without_rattlers;  ///< z of the others without contacts to rattlers; NaN if all are rattlers
};

/// Measures a packing. `spheres` are those of ordered grains, and `cells` the cells of these; `on_walls` and `rattler`
/// have one entry for each sphere (wall_contacts, rattlers). Errors are the jackknife over `blocks` sectors about the
/// axis of the core: the blocks of a single packing are correlated, so they are a guide. Validated by
/// tests/unit/sphere_packing_test.cpp.
SpherePacking measure_sphere_packing(const Spheres& spheres, const std::vector<SphereCell>& cells,
                                     const ContactGraph& graph, const std::vector<std::uint8_t>& on_walls,
                                     const std::vector<std::uint8_t>& rattler, const PackingCore& core,
                                     std::size_t blocks = 8);

/// Solid fraction in rings about an axis.
struct RadialSolidFraction {
  std::vector<double> radius;  ///< [L] middles of the rings
  std::vector<double> value;   ///< volume of spheres in the ring over its volume
};

/// The solid fraction between the levels of a core in rings of equal width, `width` [L] at most, up to its radius,
/// which must be finite. All spheres count, base spheres too, cut at rings and levels. A sphere is divided by
/// quadrature over its columns, 40 across it, and scaled to its exact volume between the levels: the sum over rings is
/// exact, and the part of one sphere in one ring is accurate to about 5e-3 of its volume. Overlaps count twice.
RadialSolidFraction radial_solid_fraction(const Spheres& spheres, const PackingCore& core, double width);

/// Volume [L^3] of the part z < height of a sphere about the origin: pi (h + r)^2 (2 r - h)/3. Exact to rounding.
double sphere_volume_below(double radius, double height);

}  // namespace repose
