// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace repose {

class Problems;
struct Scene;

/// A grain that the scene puts in its place.
struct PlacedGrain {
  std::array<double, 2> position{unset, unset};  ///< [L]
  std::array<double, 2> velocity{};              ///< [L/T]
  double spin = 0.0;                             ///< [1/T]
  double diameter = unset;                       ///< [L]
  bool fixed = false;
  std::string material;
};

/// Grains that exist at the start, from elsewhere.
struct StartFrom {
  std::string from;        ///< a run folder, its run.h5, or a file of grains; "": nothing
  std::int64_t step = -1;  ///< of the snapshot of a LAMMPS dump; -1: the last
  bool at_rest = false;    ///< velocities are left behind

  // What reading the scene finds there.
  std::string path;        ///< from, as the program opens it
  bool histories = false;  ///< contacts remember what they did in the run that it comes from
  bool base = false;       ///< some of the grains are base grains
  std::int64_t moving = 0;
  double smallest = 0.0;  ///< [L] diameter; 0 without grains
  double largest = 0.0;   ///< [L]
  double fall = 0.0;      ///< [L] height from which the fastest grain seems to fall
};

/// start.*, [[grain]] and source.*.
void source_keys(Scene& scene, Parameters& keys);
void check_sources(const Scene& scene, Problems& problems);

}  // namespace repose
