// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/chains.hpp"
#include "repose/analysis/core_region.hpp"
#include "repose/analysis/fields.hpp"
#include "repose/analysis/force_lines.hpp"
#include "repose/analysis/force_network.hpp"
#include "repose/analysis/force_statistics.hpp"
#include "repose/analysis/grain_stress.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/analysis/motion.hpp"
#include "repose/analysis/packing.hpp"
#include "repose/analysis/voronoi.hpp"
#include "repose/record/record.hpp"
#include "repose/results/column.hpp"
#include "repose/results/force_range.hpp"
#include "repose/results/slips.hpp"
#include "repose/results/stability.hpp"
#include "repose/results/wall_forces.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// Everything that the analysis says of a run.
template <int D = 2>
struct Results;

template <>
struct Results<2> {
  HeapShape heap;
  ForceNetwork network;
  std::optional<BaseDip> dip;
  std::optional<double> base_scatter;
  BinnedProfile base;
  double max_overlap = 0.0;            ///< over the mean diameter of the pair
  double force_unit = 0.0;             ///< [M L/T^2] by analysis.force_scale
  WallForces walls;                    ///< mean over output.window
  std::optional<ColumnState> column;   ///< where two upright walls face each other
  double base_height = 0.0;            ///< [L]
  std::optional<double> weight_error;  ///< vertical force on the supports over the weight they carry, less 1
  std::vector<VoronoiCell> cells;
  std::vector<GrainStress> grain_stress;  ///< of all grains, by ascending id
  CoreRegion core;
  std::optional<ForceStatistics> forces;
  Chains chains;
  ForceLines force_lines;
  Fields fields;
  std::optional<double> field_weight_error;  ///< integral of the density field over the mass of the heap, less 1
  Motion motion;
  std::optional<Packing> packing;
  std::string packing_problem;  ///< why there is none although it was asked for
  std::vector<std::int64_t>
      neighbours;  ///< touching grains of each grain, by its place in the record, with the packing
  std::optional<ForceRange> force_range;  ///< where it was asked for; `analyse` leaves it out
  std::optional<Stability> stability;     ///< likewise
  std::optional<Slips> slips;             ///< likewise
  std::int64_t breaking_rule = 0;         ///< deposited discs that do not rest by the critical-angle rule
};

Results<2> analyse(const Record<2>& record);

}  // namespace repose
