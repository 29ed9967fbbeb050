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
Moment read_frame(const std::string& path, const Record& last);

/// The walls that stand, as lines; an endless one ends a little beyond the grains.
std::vector<WallLine> lines_of(const std::vector<RecordedWall>& walls, const Moment& moment);

}  // namespace repose
