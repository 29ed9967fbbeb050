// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/scene/sizes.hpp"

#include <string>

namespace repose {

class Problems;
struct Scene;

/// The grains of a scene without species, and the grain that masses refer to.
struct GrainSizes {
  double diameter = unset;              ///< [L] the largest, and that of base grains
  double mass = unset;                  ///< [M] of a grain of that diameter; unset in SI where densities give it
  double polydispersity = 0.0;          ///< p: sizes uniform in [(1 - p) d, d]
  std::string fractions_by = "number";  ///< fractions of species are by "number" or "mass"
};

/// Grains of one material, with a distribution of sizes.
struct Species {
  std::string name;
  std::string material;
  double fraction = 1.0;  ///< over the sum of all shares
  Chosen<SizesKind> sizes;
};

/// grains.*.
void grain_keys(Scene& scene, Parameters& keys);
/// [[species]].
void species_keys(Scene& scene, Parameters& keys);
void check_species(const Scene& scene, Problems& problems);

/// A line for `repose check`.
std::string describe_species(const Species& species, const Scene& scene);

}  // namespace repose
