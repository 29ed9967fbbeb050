// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

class Problems;
struct Scene;

/// A grain that the scene puts in its place.
struct PlacedGrain {
  Coordinates position = no_coordinates;  ///< [L]
  Coordinates velocity{};                 ///< [L/T]
  Coordinates spin{};                     ///< [1/T] in two dimensions the first number, counter-clockwise
  double diameter = unset;                ///< [L]
  bool fixed = false;
  std::string material;
};

/// Grains that exist at the start, from elsewhere.
struct StartFrom {
  std::string from;        ///< a run folder, its run.h5, or a file of grains; "": nothing
  std::int64_t step = -1;  ///< of the snapshot of a file with several; -1: the last
  bool at_rest = false;    ///< velocities are left behind

  // How the places of the file become places of the scene: plane, scale, flip, shift, in this order.
  std::string plane = "xy";         ///< of a file in three dimensions
  double tolerance = unset;         ///< [L] across the plane
  double scale = 1.0;               ///< of lengths and velocities
  std::string flip = "none";        ///< the axis whose sign changes
  Coordinates shift{};              ///< [L]
  std::vector<double> fixed_types;  ///< types of the file whose grains are fixed

  // What reading the scene finds there.
  std::string path;        ///< from, as the program opens it
  bool expected = false;   ///< the run that it comes from is yet to come
  bool histories = false;  ///< contacts remember what they did in the run that it comes from
  bool base = false;       ///< some of the grains are base grains
  std::int64_t moving = 0;
  double smallest = 0.0;    ///< [L] diameter; 0 without grains
  double largest = 0.0;     ///< [L]
  double fall = 0.0;        ///< [L] height from which the fastest grain seems to fall
  double lightest = 1.0;    ///< least mass of a moving grain over that of a grain of its size in the scene
  double total_mass = 0.0;  ///< [M] of moving grains
  double total_size = 0.0;  ///< [L] sum of the diameters of moving grains
  std::string description;  ///< what was read, lines for `repose check`
  std::vector<std::string> warnings;
};

/// start.*, [[grain]] and source.*.
void source_keys(Scene& scene, Parameters& keys);
void check_sources(const Scene& scene, Problems& problems);

}  // namespace repose
