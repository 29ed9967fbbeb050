// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace repose {

class Problems;
struct Scene;

/// When a run ends: whichever comes first.
struct StopKeys {
  std::optional<double> at_rest;
  std::optional<double> time;  ///< [T]
};

struct OutputKeys {
  double series = unset;     ///< [T] between two rows of the time series
  double frames = unset;     ///< [T] between two saved frames; 0: none
  double window = unset;     ///< [T] over which base forces are averaged
  double track = 0.0;        ///< [T] between two moments of the track; 0: none
  double checkpoint = 60.0;  ///< [s] of wall time between checkpoints; 0: only when interrupted
  bool energy = false;       ///< keep the energy budget
  std::int64_t slices = 10;  ///< of a column between two upright walls or in an upright cylinder
};

struct AnalysisKeys {
  double bin_width = unset;      ///< [L]
  std::string force_scale;       ///< "weight", "mean" or "given": the unit of the two thresholds below
  double force = unset;          ///< [M L/T^2] the given one
  double force_threshold = 0.2;  ///< [that unit]
  double base_bin = unset;       ///< [L]
  double base_cell = unset;      ///< [L] in three dimensions
  double field_width = unset;    ///< [L]
  double core_depth = unset;     ///< [L]
  double moved = unset;          ///< [L]
  std::int64_t avalanche = 10;   ///< grains
  double burst = 5.0;            ///< [that unit times diameters]

  std::optional<bool> packing;               ///< measure the packing in a slab; none: as the scene suggests
  std::array<double, 2> slab{unset, unset};  ///< its edges above the base centres, over the mean height of the grains
  double contact_gap = unset;                ///< [mean diameters of the pair]
  std::int64_t direction_bins = 36;
  bool correlations = false;
  bool structure_factor = false;
  bool local_density = false;
  bool slips = false;  ///< find the slips of a driven wall
};

/// stop.*, output.* and analysis.*.
void output_keys(Scene& scene, Parameters& keys);
void check_stop(const Scene& scene, Problems& problems);
void check_force_scale(const Scene& scene, Problems& problems);
/// Checks the slab, and that lengths of the analysis are such that a heap has a sensible number of bins and cells.
void check_analysis(const Scene& scene, Problems& problems);
void check_slab(const Scene& scene, Problems& problems);

}  // namespace repose
