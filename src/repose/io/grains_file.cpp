// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grains_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

/// The first lines of a file, each with its cells between blanks; lines that are blank are left out.
struct Beginning {
  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> cells;

  explicit Beginning(TextLines& file) {
    constexpr std::size_t most = 60;
    std::string text;
    std::vector<std::string_view> split_line;
    while (lines.size() < most && file.next(text)) {
      split(std::string_view(text).substr(0, 4096), blanks, split_line);
      if (split_line.empty()) continue;
      cells.emplace_back(split_line.begin(), split_line.end());
      lines.push_back(text.substr(0, 4096));
    }
    file.rewind();
  }

  std::size_t numbers(std::size_t line) const {
    if (line >= cells.size()) return 0;
    const auto& row = cells[line];
    return std::all_of(row.begin(), row.end(), [](const auto& cell) { return number_of(cell).has_value(); })
               ? row.size()
               : 0;
  }
  bool first_line_starts_with(std::string_view text) const {
    return !lines.empty() && trimmed(lines.front()).starts_with(text);
  }
};

bool is_lammps_data(const Beginning& file) {
  for (std::size_t k = 0; k < file.cells.size(); ++k) {
    const auto& words = file.cells[k];
    const bool count = words.size() >= 2 && words[1] == "atoms" && integer_of(words[0]).has_value();
    if (count && (words.size() == 2 || words[2].starts_with('#'))) return true;
  }
  return false;
}

/// The number of grains in the first line, and in the second a comment, or numbers that are no grain.
bool is_xyz(const Beginning& file) {
  if (file.cells.size() < 2 || file.cells[0].size() != 1 || !integer_of(file.cells[0][0])) return false;
  return true;
}

bool is_mercury(const Beginning& file) {
  const auto head = file.numbers(0);
  const auto row = file.numbers(1);
  if (!(head == 8 && row == 14) && !(head == 6 && row == 8)) return false;
  const auto count = integer_of(file.cells[0][0]);
  return count && *count >= 0;
}

/// Files of other programs that hold no grains which can be read, by their first words.
struct Unknown {
  std::string_view beginning;
  const char* what;
};
constexpr Unknown unknown_files[] = {
    {"# vtk DataFile", "is a legacy VTK file; open it in ParaView and save its points as CSV"},
    {"<?xml", "is an XML file, of VTK perhaps; open it in ParaView and save its points as CSV"},
    {"<VTKFile", "is a VTK file; open it in ParaView and save its points as CSV"},
    {"<", "is an XML or HTML file; must be a table of text"},
    {"{", "is a JSON file; write a table with a line of names, then a row for each grain"},
    {"[", "is a TOML, INI or JSON file; write a table with a line of names, then a row for each grain"},
    {"ITASCA", "is a geometry of ITASCA; write the balls as a table with the names id, pos-x, pos-y, radius"},
    {"solid ", "is an STL geometry; must hold grains"},
    {"OFF", "is an OFF geometry; must hold grains"},
    {"ply", "is a PLY geometry; must hold grains"},
    {"MercuryDPM", "is a restart file of MercuryDPM; read its .data file"},
    {"restart_version", "is a restart file of MercuryDPM; read its .data file"},
    {"LIGGGHTS Description", "is an export of YADE for LIGGGHTS; export it as x_y_z_r"},
};

void refuse_unknown(const Beginning& file, FileProblems& problems) {
  for (const auto& unknown : unknown_files) {
    if (file.first_line_starts_with(unknown.beginning)) problems.stop_without_line(unknown.what);
  }
}

SeenFile read_seen(const std::string& path, const ReaderOptions& options) {
  TextLines lines(path);
  FileProblems problems(path);
  const Beginning beginning(lines);
  if (beginning.first_line_starts_with("ITEM:")) return read_lammps_dump(lines, problems, options);
  refuse_unknown(beginning, problems);
  if (is_xyz(beginning)) return read_extended_xyz(lines, problems, options);
  if (is_mercury(beginning)) return read_mercury_data(lines, problems, options);
  if (options.step != last_snapshot) {
    problems.stop_without_line(fmt::format("has no snapshots, so none of step {}", options.step));
  }
  if (is_lammps_data(beginning)) return read_lammps_data(lines, problems, options);
  if (beginning.first_line_starts_with("#format ")) return read_yade_text(lines, problems, options);
  return read_grains_table(lines, problems, options);
}

GrainsFile<2> in_the_plane(SeenFile file) {
  GrainsFile<2> made;
  static_cast<FileFacts&>(made) = static_cast<FileFacts&&>(file);
  if (file.box) {
    made.box = {{{file.box->low[0], file.box->low[1]}},
                {{file.box->high[0], file.box->high[1]}},
                {file.box->sides[0], file.box->sides[1]},
                file.box->tilted};
  }
  made.grains.reserve(file.grains.size());
  for (const auto& row : file.grains) {
    made.grains.push_back({.id = row.id,
                           .position = {{row.position[0], row.position[1]}},
                           .velocity = {{row.velocity[0], row.velocity[1]}},
                           .spin = row.spin[2],
                           .radius = row.radius,
                           .mass = row.mass,
                           .material = row.material,
                           .fixed = row.fixed,
                           .base = row.base,
                           .type = row.type,
                           .third = row.position[2],
                           .line = row.line});
  }
  return made;
}

}  // namespace

template <>
GrainsFile<2> read_grains_file(const std::string& path, const GrainsFileOptions& options) {
  return in_the_plane(read_seen(path, {options}));
}

template <>
GrainsFile<3> read_grains_file(const std::string& path, const GrainsFileOptions& options) {
  REPOSE_ASSERT(options.plane == Plane::xy);
  return read_seen(path, {options, true});
}

}  // namespace repose
