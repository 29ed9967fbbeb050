// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/exports.hpp"
#include "repose/record/record.hpp"

#include <string>
#include <vector>

namespace repose {

/// Names of the saved frames that run.h5 names, ascending. A frame that it does not name belongs to a run that was cut
/// off. Throws InputError.
std::vector<std::string> saved_frames(const std::string& folder);

/// The file of a saved frame.
std::string frame_path(const std::string& folder, const std::string& name);

/// Reads a saved frame of the run with this last state. Throws InputError if it is missing, damaged or of another run.
template <int D>
Moment<D> read_frame(const std::string& path, const Record<D>& last);

/// The walls that stand, as lines; an endless one ends a little beyond the grains.
std::vector<WallLine> lines_of(const std::vector<RecordedWall<2>>& walls, const Moment<2>& moment);

/// The walls of spheres that stand, as triangles: an endless one as a rectangle that ends a little beyond the grains,
/// round ones by 48 segments of their rims.
std::vector<WallSurface> surfaces_of(const std::vector<RecordedWall<3>>& walls, const Moment<3>& moment);

}  // namespace repose
