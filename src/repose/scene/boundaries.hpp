// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/parameters.hpp"
#include "repose/scene/drums.hpp"
#include "repose/scene/motions.hpp"
#include "repose/scene/wall_shapes.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace repose {

class Problems;
struct Scene;

/// The region in which grains are.
struct Region {
  std::string x;                ///< at the sides: "open" or "periodic"; "walls" where grains are put in place
  double half_width = unset;    ///< [L]
  std::string y;                ///< in three dimensions, as x
  double half_depth = unset;    ///< [L] along y
  std::optional<double> floor;  ///< [L] grains that fall below are lost; none: "auto"

  bool periodic() const { return x == "periodic"; }
  bool periodic_y() const { return y == "periodic"; }
  bool open() const { return x == "open"; }
  bool walled() const { return x == "walls"; }
};

/// A wall: endless, through a point, or straight from one end to the other, in three dimensions of some shape; and what
/// moves it.
struct SceneWall {
  std::string name;
  Coordinates point = no_coordinates;
  Coordinates normal = no_coordinates;
  Coordinates from = no_coordinates;
  Coordinates to = no_coordinates;
  Chosen<ShapeKind> shape;  ///< of a wall of finite extent in three dimensions
  bool smooth = false;
  std::string material;
  Chosen<MotionKind> motion;
  std::optional<double> opens_at;  ///< [T] it does not exist from then on
};

/// A force on one grain.
struct SceneLoad {
  std::int64_t grain = -1;             ///< id, or -1: the moving grain nearest to the position
  Coordinates position{};              ///< [L]
  Coordinates force = no_coordinates;  ///< [M L/T^2]
  double start = 0.0;                  ///< [T]
};

/// base.*, box.*, [[plane]], [[wall]] and [[load]].
void boundary_keys(Scene& scene, Parameters& keys);
void check_boundaries(const Scene& scene, Problems& problems);

}  // namespace repose
