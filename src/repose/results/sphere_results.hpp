// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/axial_fields.hpp"
#include "repose/analysis/base_cells.hpp"
#include "repose/analysis/base_rings.hpp"
#include "repose/analysis/chains.hpp"
#include "repose/analysis/cone_shape.hpp"
#include "repose/analysis/contact_fabric.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/force_statistics.hpp"
#include "repose/analysis/sphere_cells.hpp"
#include "repose/analysis/sphere_packing.hpp"
#include "repose/analysis/sphere_structure.hpp"
#include "repose/record/record.hpp"
#include "repose/results/column.hpp"
#include "repose/results/results.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// The force of the grains on one wall, mean over an interval.
struct SphereWallForce {
  std::string name;
  Vec<3> force{};  ///< [M L/T^2]
};

/// The walls of a record in their order, and the interval of the means.
struct SphereWallForces {
  double window_start = 0.0;  ///< [T]
  double window_end = 0.0;    ///< [T]
  std::vector<SphereWallForce> walls;
};

/// The core of a conical heap: the spheres with closed cells away from its surface and its base.
struct ConeCore {
  std::size_t grains = 0;
  std::optional<double> solid_fraction;  ///< volume of the spheres over that of their Voronoi cells
  std::optional<double> coordination;    ///< mean number of contacts above the threshold
};

/// Everything that the analysis says of a run of spheres.
template <>
struct Results<3> {
  double force_unit = 0.0;             ///< [M L/T^2] by analysis.force_scale
  double max_overlap = 0.0;            ///< over the mean diameter of the pair
  double base_height = 0.0;            ///< [L]
  std::optional<double> weight_error;  ///< vertical force on the supports over the weight they carry, less 1
  NetworkOfForces<3> network;
  ConicalHeap cone;
  ConeCore core;
  BaseRings base;        ///< mean over output.window; on a floor at one time
  BaseCells base_cells;  ///< the same loads by cells
  SphereWallForces walls;
  std::optional<ColumnState> column;  ///< in an upright cylinder
  std::optional<ForceStatistics> forces;
  Chains chains;
  std::optional<ContactFabric> fabric;
  AxialFields fields;
  std::optional<double> field_mass_error;  ///< integral of the density over the mass of the heap, less 1
  std::vector<SphereCell> cells;
  std::optional<PackingCore> slab;  ///< the part of the packing that the next numbers measure
  std::optional<SpherePacking> packing;
  std::optional<Correlation> pair_correlation;
  std::optional<IsotropicStructureFactor> structure_factor;
};

Results<3> analyse(const Record<3>& record);

}  // namespace repose
