// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"

#include <optional>
#include <string>

namespace repose {

class Problems;
struct Scene;

struct Material {
  std::string name;
  /// Over that of a grain of grains.mass and grains.diameter; in SI [M/L^3], and grains.mass follows from it.
  double density = unset;
  std::optional<double> young_modulus = std::nullopt;  ///< E [M/(L T^2)]
  std::optional<double> poisson_ratio = std::nullopt;  ///< nu
  std::string library = "none";  ///< material_library.hpp: gives what the scene leaves out; in SI alone
};

/// [[material]].
void material_keys(Scene& scene, Parameters& keys);
void check_materials(const Scene& scene, Problems& problems);

/// Mass and density of grains, of which one follows from the other in SI.
void check_masses(const Scene& scene, Problems& problems);

/// Lines for `repose check`: units, masses and weights, and elastic constants.
std::string describe_materials(const Scene& scene);

}  // namespace repose
