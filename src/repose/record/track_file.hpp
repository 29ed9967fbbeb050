// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/track.hpp"
#include "repose/io/columns.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace repose {

/// The datasets of a segment of the track: of its moments, and of the grains of all moments one after the other.
const Columns<Track>& track_moment_columns();
const Columns<std::vector<TrackedGrain>>& track_grain_columns();

/// Writes a segment of the track: the moments from `first` on, with the hash of the scene. Throws RunError.
void write_track_segment(const std::string& path, const std::string& scene_hash, const Track& track, std::size_t first);

/// Adds the moments of a segment to a track. Throws InputError, also if it is that of another scene ("": unknown).
void read_track_segment(const std::string& path, const std::string& scene_hash, Track& track);

}  // namespace repose
