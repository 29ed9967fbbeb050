// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/moments.hpp"

#include "repose/io/state.hpp"
#include "repose/record/record_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

WallLine line_of(const Wall<2>& wall, std::int64_t number, const Moment& moment) {
  const Vec<2> along{{wall.normal[1], -wall.normal[0]}};
  if (wall.finite()) {
    return {wall.point - along * wall.half_length, wall.point + along * wall.half_length, number};
  }
  double first = 0.0, last = 0.0;
  for (const auto& grain : moment.grains->line) {
    const double place = dot(Vec<2>(grain.position - wall.point), along);
    first = std::min(first, place - 2.0 * grain.radius);
    last = std::max(last, place + 2.0 * grain.radius);
  }
  return {wall.point + along * first, wall.point + along * last, number};
}

}  // namespace

std::vector<std::string> saved_frames(const std::string& folder) {
  const Hdf5Reader run(folder + "/run.h5");
  const auto groups = run.names_in("/");
  if (std::find(groups.begin(), groups.end(), "frames") == groups.end()) return {};
  return run.names_in("frames");
}

std::string frame_path(const std::string& folder, const std::string& name) {
  return fmt::format("{}/frames/{}.h5", folder, name);
}

Moment read_frame(const std::string& path, const Record& last) {
  const Hdf5Reader file(path);
  check_belongs(file, last.facts);
  Moment moment{
      file.number("/", "time"), file.integer("/", "steps"), {read_grains<2>(file), last.box}, read_contacts<2>(file)};
  check_partners(path, moment.grains, moment.contacts, last.walls.size());
  return moment;
}

std::vector<WallLine> lines_of(const std::vector<RecordedWall>& walls, const Moment& moment) {
  std::vector<WallLine> lines;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!walls[w].open) lines.push_back(line_of(walls[w].wall, static_cast<std::int64_t>(w), moment));
  }
  return lines;
}

}  // namespace repose
