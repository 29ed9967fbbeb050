// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/statistics.hpp"
#include "repose/record/record.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace repose {

/// A slice of a column (analysis/pipe.hpp), mean over output.window.
struct ColumnLayer {
  double depth = 0.0;           ///< [L] of its middle below the surface
  double bottom = 0.0;          ///< [L] of its lower level above the floor
  double top = 0.0;             ///< [L]
  double mass = 0.0;            ///< [M]
  double solid_fraction = 0.0;  ///< disc area over area, in 3D volume of the spheres over volume
  double pressure = 0.0;        ///< [M/T^2], in 3D [M/(L T^2)] on the walls
  double shear = 0.0;           ///< [M/T^2], in 3D [M/(L T^2)] of the walls, upwards on the grains
  double stress = 0.0;          ///< likewise, vertical: mean of the loads of its two levels, over the cross-section
  double load = 0.0;            ///< [M L/T^2] through its lower level
};

/// Janssen's law fitted to the loads of all levels of a column: with one length, and with two (Bratberg 2003, eqs (25)
/// and (38), corrected). Errors are from the scatter of the residuals.
struct ColumnFit {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double lambda = none, lambda_error = none;      ///< [L] the one length
  double lambda_1 = none, lambda_1_error = none;  ///< [L] sets the size of the load
  double lambda_2 = none, lambda_2_error = none;  ///< [L] over which it changes
  double residual = none;                         ///< [M] root of the mean square of the residuals, of one length
  double residual_two = none;                     ///< [M] of two
};

/// How far a moving floor has moved the column.
struct ColumnMotion {
  double time = 0.0;        ///< [T]
  double floor = 0.0;       ///< [L] displacement of the floor, upwards
  double top = 0.0;         ///< [L] displacement of the surface, upwards
  double shortening = 0.0;  ///< [L] by which the column has become shorter since the floor set out
  double front = 0.0;       ///< [L] height, above the floor as it set out, up to which all slices have moved with it
};

/// A column between two upright walls, or of spheres in an upright cylinder, mean over output.window. See
/// docs/physics/columns.md and docs/physics/spheres.md.
struct ColumnState {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double width = none;                   ///< [L] between the walls; of discs alone
  double radius = none;                  ///< [L] of the cylinder; of spheres alone
  Vec<2> axis{};                         ///< [L] x, y of the axis of the cylinder at the end
  double floor = 0.0;                    ///< [L] height of the floor at the end
  std::int64_t floor_wall = -1;          ///< number of the wall that is the floor; -1: base grains
  double height = none;                  ///< [L] of the surface above the floor
  double mass = none;                    ///< [M] of its grains
  double solid_fraction = none;          ///< of all slices but the lowest and the highest tenth
  double apparent_mass = none;           ///< [M] load of the floor over gravity
  double load_ratio = none;              ///< load of the floor over the weight
  double wall_load = none;               ///< [M L/T^2] upward force of the walls on the grains
  double balance = none;                 ///< load of the floor and of the walls over the weight, less 1
  std::optional<Estimate> stress_ratio;  ///< K: wall pressure over vertical stress
  double friction = none;                ///< upward force of the walls over the normal force on them
  double screening_length = none;  ///< [L] width, or radius, over 2 K friction; negative where the walls push down
  double janssen_ratio = none;     ///< load_ratio by Janssen's law with that length
  ColumnFit fit;
  std::vector<ColumnLayer> layers;  ///< from the floor up

  double shortening = none;          ///< [L] since the floor set out
  double later_shortening = none;    ///< [L] of it, what came after all slices had followed
  double top_follows = none;         ///< [L] displacement of the floor when the top slice has moved half as far as it
  std::vector<ColumnMotion> motion;  ///< from when the floor sets out; empty where it stands
};

/// The column of a record; none where its scene has no pipe, or no rows. A cylinder has none either where no grain has
/// been inside: grains may lie around it.
template <int D>
std::optional<ColumnState> measure_column_of(const Record<D>& record);

}  // namespace repose
