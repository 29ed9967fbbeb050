// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/grain_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <istream>

namespace repose {

namespace {

/// The names of columns. The long names are those that `repose export` writes.
struct Name {
  const char* name;
  GrainColumn column;
};
constexpr Name names[] = {
    {"x", GrainColumn::x},           {"position_x", GrainColumn::x},      {"y", GrainColumn::y},
    {"position_y", GrainColumn::y},  {"radius", GrainColumn::radius},     {"diameter", GrainColumn::diameter},
    {"vx", GrainColumn::vx},         {"velocity_x", GrainColumn::vx},     {"vy", GrainColumn::vy},
    {"velocity_y", GrainColumn::vy}, {"spin", GrainColumn::spin},         {"mass", GrainColumn::mass},
    {"id", GrainColumn::id},         {"material", GrainColumn::material}, {"fixed", GrainColumn::fixed},
    {"base", GrainColumn::base},
};
constexpr const char* known = "x, y, radius or diameter, vx, vy, spin, mass, id, material, fixed, base";

std::string_view trimmed(std::string_view cell) {
  const auto begin = cell.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  cell = cell.substr(begin, cell.find_last_not_of(" \t\r") - begin + 1);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

/// The cells of a line. Separators within quotes are text.
void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == '"') quoted = !quoted;
    if (line[k] != separator || quoted) continue;
    cells.push_back(trimmed(line.substr(begin, k - begin)));
    begin = k + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
}

char separator_of(std::string_view header) {
  for (const char separator : {';', '\t'}) {
    if (header.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

GrainLines read_header(std::size_t line, const std::vector<std::string_view>& cells, FileProblems& problems) {
  if (number_of(cells.front())) problems.stop(line, "must be the names of the columns, above the numbers");
  std::vector<GrainColumn> columns;
  std::vector<std::string> given(cells.begin(), cells.end());
  for (const auto& cell : given) {
    const auto* found = std::find_if(std::begin(names), std::end(names), [&](const auto& n) { return n.name == cell; });
    if (found == std::end(names)) {
      problems.add(line, fmt::format("{}: unknown column; known are {}", cell, known));
      columns.push_back(GrainColumn::none);
      continue;
    }
    if (std::find(columns.begin(), columns.end(), found->column) != columns.end()) {
      problems.add(line, fmt::format("{}: occurs twice", cell));
    }
    columns.push_back(found->column);
  }
  const auto count = [&](GrainColumn column) { return std::count(columns.begin(), columns.end(), column); };
  const bool one_size = count(GrainColumn::radius) + count(GrainColumn::diameter) == 1;
  if (count(GrainColumn::x) == 0 || count(GrainColumn::y) == 0 || !one_size) {
    problems.stop(line, "must have the columns x, y, and either radius or diameter");
  }
  return {problems, columns, given};
}

}  // namespace

std::vector<GrainRow> read_grains_table(std::istream& file, FileProblems& problems) {
  std::optional<GrainLines> grains;
  std::vector<std::string_view> cells;
  char separator = ',';
  std::size_t line = 0;
  for (std::string text; std::getline(file, text);) {
    constexpr const char* byte_order_mark = "\xEF\xBB\xBF";
    if (++line == 1 && text.starts_with(byte_order_mark)) text.erase(0, 3);
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos || text[begin] == '#') continue;
    if (!grains) separator = separator_of(text);
    split(text, separator, cells);
    if (grains) {
      grains->read(line, cells);
    } else {
      grains.emplace(read_header(line, cells, problems));
    }
  }
  if (!grains) throw InputError(fmt::format("{}: is empty: no line with the names of the columns", problems.path()));
  return grains->take();
}

}  // namespace repose
