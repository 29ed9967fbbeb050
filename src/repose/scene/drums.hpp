// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/parameters.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace repose {

class Problems;
struct Scene;

/// A rotating drum: a closed ring of straight walls about a centre.
struct SceneDrum {
  std::string name;
  Coordinates centre{};     ///< [L]
  double radius = unset;    ///< [L] of the circle through the middles of the walls
  std::int64_t pieces = 0;  ///< walls of the ring
  std::string material;
  double angular_velocity = unset;  ///< [1/T] counter-clockwise
  double start = 0.0;               ///< [T] it stands still until then
  std::optional<double> stop;       ///< [T] it stands still from then on
};

/// [[drum]].
void drum_keys(Scene& scene, Parameters& keys);

/// The walls of a drum at the start, one after the other.
std::vector<Wall<2>> drum_walls(const SceneDrum& drum, std::uint16_t material);
std::vector<std::string> drum_wall_names(const SceneDrum& drum);

}  // namespace repose
