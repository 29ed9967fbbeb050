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

template <int D>
std::vector<std::int64_t> offsets(const Track<D>& track) {
  std::vector<std::int64_t> all{0};
  for (const auto& moment : track) all.push_back(all.back() + static_cast<std::int64_t>(moment.grains.size()));
  return all;
}

}  // namespace

template <int D>
const Columns<Track<D>>& track_moment_columns() {
  static const Columns<Track<D>> list{
      column("time", &TrackMoment<D>::time, "T", "of each moment"),
      with_rows("M + 1",
                array<Track<D>>("offset", offsets<D>, "", "grains of moment m are rows offset[m] to offset[m + 1]")),
  };
  return list;
}

template <int D>
const Columns<std::vector<TrackedGrain<D>>>& track_grain_columns() {
  using Row = TrackedGrain<D>;
  static const Columns<std::vector<Row>> list{
      column("id", &Row::id, "", "stable id, ascending within a moment"),
      column<Row>(
          "position", [](auto& grain) { return std::apply([](auto&... x) { return std::tie(x...); }, grain.position); },
          "L", "centre"),
      column("radius", &Row::radius, "L", "radius"),
      column("kinetic_energy", &Row::kinetic_energy, "M L^2/T^2", "translation and rotation"),
      column("in_heap", &Row::in_heap, "", "1: touches something"),
  };
  return list;
}

template <int D>
void write_track_segment(const std::string& path, const std::string& scene_hash, const Track<D>& track,
                         std::size_t first) {
  const Track<D> segment(track.begin() + static_cast<std::ptrdiff_t>(first), track.end());
  std::vector<TrackedGrain<D>> grains;
  for (const auto& moment : segment) grains.insert(grains.end(), moment.grains.begin(), moment.grains.end());
  Hdf5File file(path);
  file.attribute("/", "scene_hash", scene_hash);
  write_columns(file, "", track_moment_columns<D>(), segment);
  write_columns(file, "", track_grain_columns<D>(), grains);
  file.commit();
}

template <int D>
void read_track_segment(const std::string& path, const std::string& scene_hash, Track<D>& track) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(fmt::format("{}: is missing", path));
  const Hdf5Reader file(path);
  if (!scene_hash.empty() && file.text_or("/", "scene_hash", scene_hash) != scene_hash) {
    throw InputError(fmt::format("{}: belongs to another run", path));
  }
  Track<D> segment;
  read_columns(file, "", track_moment_columns<D>(), segment);
  std::vector<TrackedGrain<D>> grains;
  read_columns(file, "", track_grain_columns<D>(), grains);
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

template const Columns<Track<2>>& track_moment_columns();
template const Columns<std::vector<TrackedGrain<2>>>& track_grain_columns();
template void write_track_segment(const std::string&, const std::string&, const Track<2>&, std::size_t);
template void read_track_segment(const std::string&, const std::string&, Track<2>&);
template const Columns<Track<3>>& track_moment_columns();
template const Columns<std::vector<TrackedGrain<3>>>& track_grain_columns();
template void write_track_segment(const std::string&, const std::string&, const Track<3>&, std::size_t);
template void read_track_segment(const std::string&, const std::string&, Track<3>&);

}  // namespace repose
