// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/exports.hpp"
#include "repose/record/recorded_wall.hpp"

#include <vector>

namespace repose {

/// Gives each grain of a moment its stress (analysis/grain_stress.hpp) and the part of the plane that this is a mean
/// over. `walls` are those of the moment.
void add_stress(Moment<2>& moment, const std::vector<RecordedWall<2>>& walls, const Box<2>& box);

/// The same for spheres: 1/volume times the sum over the contacts of a grain of the force on it and the branch from the
/// contact point to its centre, compression positive. The volume is that of the Voronoi cell where it is closed
/// (analysis/sphere_cells.hpp), else of the sphere. Flat walls with all grains on one side bound the cells, and
/// cylinders with all grains inside.
///
/// The sum over grains of volume times stress is the sum over contacts of the force on the first partner and the branch
/// from the centre of the second, or the point of the wall, to that of the first. Source: Goldhirsch and Goldenberg,
/// Eur. Phys. J. E 9, 245 (2002), eq. 1. Validated by tests/unit/exports_3d_test.cpp.
void add_stress(Moment<3>& moment, const std::vector<RecordedWall<3>>& walls, const Box<3>& box);

}  // namespace repose
