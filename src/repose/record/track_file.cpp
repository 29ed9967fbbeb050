// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/track_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <tuple>

namespace repose {

namespace {

std::vector<std::int64_t> offsets(const Track& track) {
  std::vector<std::int64_t> all{0};
  for (const auto& moment : track) all.push_back(all.back() + static_cast<std::int64_t>(moment.grains.size()));
  return all;
}

}  // namespace

const Columns<Track>& track_moment_columns() {
  static const Columns<Track> list{
      column("time", &TrackMoment::time, "T", "of each moment"),
      with_rows("M + 1", array<Track>("offset", offsets, "", "grains of moment m are rows offset[m] to offset[m + 1]")),
  };
  return list;
}

const Columns<std::vector<TrackedGrain>>& track_grain_columns() {
  static const Columns<std::vector<TrackedGrain>> list{
      column("id", &TrackedGrain::id, "", "stable id, ascending within a moment"),
      column<TrackedGrain>(
          "position", [](auto& grain) { return std::tie(grain.x, grain.y); }, "L", "centre"),
      column("radius", &TrackedGrain::radius, "L", "radius"),
      column("kinetic_energy", &TrackedGrain::kinetic_energy, "M L^2/T^2", "translation and rotation"),
      column("in_heap", &TrackedGrain::in_heap, "", "1: touches something"),
  };
  return list;
}

void write_track_segment(const std::string& path, const std::string& scene_hash, const Track& track,
                         std::size_t first) {
  const Track segment(track.begin() + static_cast<std::ptrdiff_t>(first), track.end());
  std::vector<TrackedGrain> grains;
  for (const auto& moment : segment) grains.insert(grains.end(), moment.grains.begin(), moment.grains.end());
  Hdf5File file(path);
  file.attribute("/", "scene_hash", scene_hash);
  write_columns(file, "", track_moment_columns(), segment);
  write_columns(file, "", track_grain_columns(), grains);
  file.commit();
}

void read_track_segment(const std::string& path, const std::string& scene_hash, Track& track) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(fmt::format("{}: is missing", path));
  const Hdf5Reader file(path);
  if (!scene_hash.empty() && file.text_or("/", "scene_hash", scene_hash) != scene_hash) {
    throw InputError(fmt::format("{}: belongs to another run", path));
  }
  Track segment;
  read_columns(file, "", track_moment_columns(), segment);
  std::vector<TrackedGrain> grains;
  read_columns(file, "", track_grain_columns(), grains);
  const auto offset = file.dataset<std::int64_t>("offset");
  const bool sound = offset.size() == segment.size() + 1 && offset.front() == 0 &&
                     offset.back() == static_cast<std::int64_t>(grains.size()) &&
                     std::is_sorted(offset.begin(), offset.end());
  if (!sound) throw InputError(fmt::format("{}: wrong offsets", file.path()));
  for (std::size_t m = 0; m < segment.size(); ++m) {
    segment[m].grains.assign(grains.begin() + offset[m], grains.begin() + offset[m + 1]);
    track.push_back(std::move(segment[m]));
  }
}

}  // namespace repose
