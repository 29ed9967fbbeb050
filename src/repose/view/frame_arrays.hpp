// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/exports.hpp"
#include "repose/record/record.hpp"

#include <string>
#include <vector>

namespace repose {

/// Numbers of a frame as floats, or in fewer bytes for a page that is kept as a file.
enum class Precision { full, packed };

/// The arrays of one moment, with the walls that stand then.
std::string frame_arrays(const std::string& key, const Moment<2>& moment, const std::vector<RecordedWall<2>>& walls,
                         bool forces, Precision precision = Precision::full);

}  // namespace repose
