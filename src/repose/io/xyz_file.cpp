// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace repose {

namespace {

using Entries = std::map<std::string, std::string>;

/// The entries of a line of comment: key=value, the value perhaps in quotes. Keys are in lower case.
Entries entries_of(std::string_view text) {
  Entries entries;
  std::size_t k = 0;
  while (k < text.size()) {
    const auto equals = text.find('=', k);
    if (equals == std::string_view::npos) break;
    const auto before = text.substr(k, equals - k);
    const auto begin = before.find_last_of(" \t");
    std::string key(trimmed(begin == std::string_view::npos ? before : before.substr(begin + 1)));
    for (auto& c : key) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    k = equals + 1;
    while (k < text.size() && text[k] == ' ') ++k;
    const char quote = k < text.size() ? text[k] : ' ';
    const bool quoted = quote == '"' || quote == '\'' || quote == '[' || quote == '{';
    const char close = quote == '[' ? ']' : quote == '{' ? '}' : quote;
    const auto from = quoted ? k + 1 : k;
    const auto end = std::min(quoted ? text.find(close, from) : text.find_first_of(" \t", from), text.size());
    entries[key] = std::string(text.substr(from, end - from));
    k = end + (quoted ? 1 : 0);
  }
  return entries;
}

/// The columns of one property: "velo" with three columns is vx, vy, vz.
void add_property(const std::string& name, std::int64_t count, std::vector<GrainLines::Column>& columns) {
  const auto plain = plain_name(name);
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), plain) != names.end();
  };
  using Three = std::array<GrainColumn, 3>;
  constexpr Three nothing{};
  Three vector = nothing;
  std::array<const char*, 3> names{};
  if (is({"pos", "position", "positions"})) {
    vector = {GrainColumn::x, GrainColumn::y, GrainColumn::z};
    names = {"x", "y", "z"};
  } else if (is({"velo", "vel", "velocity", "velocities"})) {
    vector = {GrainColumn::vx, GrainColumn::vy, GrainColumn::vz};
    names = {"vx", "vy", "vz"};
  } else if (is({"omega", "angularvelocity", "angvel"})) {
    vector = {GrainColumn::spin_x, GrainColumn::spin_y, GrainColumn::spin_z};
    names = {"omegax", "omegay", "omegaz"};
  }
  if (vector != nothing && (count == 3 || (count == 2 && vector[0] != GrainColumn::spin_x))) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) columns.push_back({vector[k], names[k]});
    return;
  }
  const auto known = count == 1 ? column_of(name).column : GrainColumn::none;
  for (std::int64_t k = 0; k < count; ++k) columns.push_back({known, name});
}

std::vector<GrainLines::Column> columns_of(const std::string& properties, std::size_t line, FileProblems& problems) {
  std::vector<std::string_view> words;
  split(properties, ':', words);
  std::vector<GrainLines::Column> columns;
  for (std::size_t k = 0; k + 2 < words.size(); k += 3) {
    const auto count = integer_of(words[k + 2]);
    constexpr std::int64_t most = 100;
    if (!count || *count < 1 || *count > most)
      problems.stop(line, "Properties must be name:type:count for each property");
    add_property(std::string(words[k]), *count, columns);
  }
  const auto remove_after = [&](GrainColumn first, GrainColumn second) {
    const auto is = [](GrainColumn wanted) { return [wanted](const auto& column) { return column.column == wanted; }; };
    if (std::none_of(columns.begin(), columns.end(), is(first))) return;
    for (auto& column : columns) {
      if (column.column == second) column.column = GrainColumn::none;
    }
  };
  remove_after(GrainColumn::radius, GrainColumn::diameter);
  remove_after(GrainColumn::material, GrainColumn::label);
  bool label = false;
  for (auto& column : columns) {
    if (column.column == GrainColumn::label && std::exchange(label, true)) column.column = GrainColumn::none;
  }
  return columns;
}

std::optional<SeenBox> box_of(const Entries& entries, const ReaderOptions& options) {
  const auto lattice = entries.find("lattice");
  if (lattice == entries.end()) return std::nullopt;
  std::vector<std::string_view> words;
  split(lattice->second, blanks, words);
  std::array<double, 9> matrix{};
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    const auto value = k < words.size() ? number_of(words[k]) : std::nullopt;
    if (!value) return std::nullopt;
    matrix[k] = *value;
  }
  std::array<double, 3> origin{};
  if (const auto given = entries.find("origin"); given != entries.end()) {
    split(given->second, blanks, words);
    for (std::size_t k = 0; k < 3 && k < words.size(); ++k) origin[k] = number_of(words[k]).value_or(0.0);
  }
  std::vector<std::string_view> periodic;
  if (const auto given = entries.find("pbc"); given != entries.end()) split(given->second, blanks, periodic);
  SeenBox box;
  for (std::size_t k = 0; k < options.axes(); ++k) {
    const auto axis = static_cast<std::size_t>(axes_of(options.plane)[k][0] - 'x');
    box.low[static_cast<int>(k)] = origin[axis];
    box.high[static_cast<int>(k)] = origin[axis] + matrix[4 * axis];
    if (axis < periodic.size()) box.sides[k] = truth_of(periodic[axis]).value_or(false) ? "periodic" : "open";
  }
  for (std::size_t k = 0; k < matrix.size(); ++k) box.tilted |= k % 4 != 0 && matrix[k] != 0.0;
  return box;
}

/// The step that a frame gives itself; its number from 0 without one.
std::int64_t step_of(const Entries& entries, std::size_t frame) {
  for (const char* key : {"timestep", "step"}) {
    const auto given = entries.find(key);
    const auto step = given == entries.end() ? std::nullopt : integer_of(given->second);
    if (step) return *step;
  }
  return static_cast<std::int64_t>(frame);
}

}  // namespace

SeenFile read_extended_xyz(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  struct Frame {
    std::size_t line;
    std::int64_t count;
    std::int64_t step;
  };
  std::optional<Frame> wanted;
  std::int64_t last = 0;
  std::size_t frames = 0;
  std::string text;
  while (lines.next(text)) {
    if (trimmed(text).empty()) continue;
    const auto line = lines.number();
    const auto count = integer_of(trimmed(text));
    if (!count || *count < 0) problems.stop(line, "must be the number of grains of a frame of an extended XYZ file");
    if (!lines.next(text)) problems.stop(line, "the file ends in the middle of a frame");
    last = step_of(entries_of(text), frames++);
    if (options.step == last_snapshot || options.step == last) wanted = Frame{line, *count, last};
    for (std::int64_t k = 0; k < *count; ++k) {
      if (!lines.next(text))
        problems.stop(lines.number(), fmt::format("the file ends after {} of {} grains", k, *count));
    }
  }
  if (!wanted)
    problems.stop(lines.number(), fmt::format("no frame of step {}; the last is of step {}", options.step, last));
  lines.rewind();
  while (lines.number() < wanted->line + 1) lines.next(text);
  const auto entries = entries_of(text);
  const auto properties = entries.find("properties");
  const auto columns = properties == entries.end() ? std::vector<GrainLines::Column>()
                                                   : columns_of(properties->second, lines.number(), problems);
  const auto has = [&](GrainColumn wanted_column) {
    return std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.column == wanted_column; });
  };
  if (!has(GrainColumn::x) || (!has(GrainColumn::radius) && !has(GrainColumn::diameter))) {
    problems.stop(lines.number(),
                  "is an XYZ file without radii; write extended XYZ with pos and radius, as in "
                  "Properties=species:S:1:pos:R:3:radius:R:1");
  }
  if (options.in_space && !has(GrainColumn::z)) {
    problems.stop(lines.number(), "is an XYZ file in two dimensions; spheres need pos:R:3");
  }
  SeenFile file;
  file.format = "extended XYZ file";
  file.box = box_of(entries, options);
  file.snapshot = wanted->step;
  file.snapshots = frames;
  GrainLines grains(problems, columns, options);
  read_rows(lines, wanted->count, problems, grains);
  grains.take(file);
  return file;
}

}  // namespace repose
