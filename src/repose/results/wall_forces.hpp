// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/record/record.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace repose {

/// The last rows of a series that together cover output.window, each with the interval since the row before.
struct WindowRows {
  std::size_t first = 0;      ///< the rows from this one
  double start = 0.0;         ///< [T]
  double end = 0.0;           ///< [T]
  std::vector<double> parts;  ///< of the interval, by row from the first; 1 together
};
WindowRows rows_of_window(const std::vector<SeriesRow>& rows, double window);

/// The force of the grains on one wall, mean over an interval.
struct WallForce {
  std::string name;
  double length = 0.0;    ///< [L] of the part that grains can press on (analysis/wall_span.hpp), at the end
  Vec<2> middle{};        ///< [L] of that part, at the end
  Vec<2> force{};         ///< [M L/T^2]
  double pressure = 0.0;  ///< [M/T^2] against the normal, per length; positive pushes into the wall; NaN without length
  double shear = 0.0;     ///< [M/T^2] along the normal turned by +90 degrees, per length
  double moment = 0.0;    ///< [M L^2/T^2] about the middle, counter-clockwise
};

/// The walls of a record in their order, and the interval of the means.
struct WallForces {
  double window_start = 0.0;  ///< [T]
  double window_end = 0.0;    ///< [T]
  std::vector<WallForce> walls;
};

/// The means over the last rows of the series that together cover output.window. Forces are those of all steps since
/// the row before; moments are those of the contacts at the rows. Empty without rows or walls. Validated by
/// tests/unit/wall_forces_test.cpp and tests/cli/test_wall_forces.py.
WallForces mean_wall_forces(const Record<2>& record);

}  // namespace repose
