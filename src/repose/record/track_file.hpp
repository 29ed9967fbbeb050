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
template <int D>
const Columns<Track<D>>& track_moment_columns();
template <int D>
const Columns<std::vector<TrackedGrain<D>>>& track_grain_columns();

/// Writes a segment of the track: the moments from `first` on, with the hash of the scene. Throws RunError.
template <int D>
void write_track_segment(const std::string& path, const std::string& scene_hash, const Track<D>& track,
                         std::size_t first);

/// Adds the moments of a segment to a track. Throws InputError, also if it is that of another scene ("": unknown).
template <int D>
void read_track_segment(const std::string& path, const std::string& scene_hash, Track<D>& track);

}  // namespace repose
