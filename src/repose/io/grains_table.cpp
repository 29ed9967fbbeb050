// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grain_columns.hpp"
#include "repose/tables/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace repose {

namespace {

bool is_length(GrainColumn column) {
  return column == GrainColumn::x || column == GrainColumn::y || column == GrainColumn::z ||
         column == GrainColumn::radius || column == GrainColumn::diameter;
}
bool is_velocity(GrainColumn column) {
  return column == GrainColumn::vx || column == GrainColumn::vy || column == GrainColumn::vz;
}

/// Which columns of a table hold what. A name of Repose's own comes before those of other programs, a radius before a
/// diameter; what comes after is left out.
std::vector<GrainColumn> quantities_of(const std::vector<ColumnName>& names) {
  std::vector<NamedColumn> found;
  for (const auto& name : names) found.push_back(column_of(name.name));
  std::vector<GrainColumn> columns;
  const auto has = [&](GrainColumn column) {
    return std::any_of(found.begin(), found.end(), [&](const auto& other) { return other.column == column; });
  };
  for (const auto& one : found) {
    const bool second = !one.own_name && std::any_of(found.begin(), found.end(), [&](const auto& other) {
      return other.own_name && other.column == one.column;
    });
    const bool other_size = one.column == GrainColumn::diameter && has(GrainColumn::radius);
    const bool other_type = one.column == GrainColumn::label && has(GrainColumn::material);
    columns.push_back(second || other_size || other_type ? GrainColumn::none : one.column);
  }
  return columns;
}

bool has(const std::vector<GrainColumn>& columns, GrainColumn column) {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

bool has_place_and_size(const std::vector<GrainColumn>& columns, const ReaderOptions& options) {
  std::vector<GrainColumn> seen;
  for (const auto column : columns) seen.push_back(in_plane(column, options.plane));
  return has(seen, GrainColumn::x) && has(seen, GrainColumn::y) && (!options.in_space || has(seen, GrainColumn::z)) &&
         (has(seen, GrainColumn::radius) || has(seen, GrainColumn::diameter));
}

/// The unit of the lengths, by the first column that gives one, and that of the masses. Time is in seconds.
FileUnits units_of(const std::vector<ColumnName>& names, const std::vector<GrainColumn>& columns) {
  FileUnits units;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto& unit = names[k].unit;
    if (unit.empty() || (!is_length(columns[k]) && columns[k] != GrainColumn::mass)) continue;
    const bool length = is_length(columns[k]);
    const auto factor = length ? unit_of_length(unit) : unit_of_mass(unit);
    auto& known = length ? units.length : units.mass;
    if (!factor || known > 0.0) continue;
    if (unit == "-" || unit == "1" || unit == "d") {
      units.reduced |= length;
      continue;
    }
    known = *factor;
    units.time = 1.0;
    units.name += (units.name.empty() ? "" : ", ") + unit;
  }
  return units;
}

/// The factor from the unit of a column to those of the file; none if the unit is unknown or does not suit.
std::optional<double> factor_of(const std::string& unit, GrainColumn column, const FileUnits& units) {
  if (unit.empty() || (units.length == 0.0 && units.mass == 0.0)) return 1.0;
  if (is_length(column)) {
    const auto factor = unit_of_length(unit);
    return factor ? std::optional<double>(*factor / units.length) : std::nullopt;
  }
  if (column == GrainColumn::mass) {
    const auto factor = unit_of_mass(unit);
    return factor ? std::optional<double>(*factor / units.mass) : std::nullopt;
  }
  if (is_velocity(column) && units.length > 0.0) {
    const auto factor = unit_of_velocity(unit);
    return factor ? std::optional<double>(*factor / units.length) : std::nullopt;
  }
  return 1.0;
}

/// The columns with their quantities, names and units; adds the problems of the names.
std::vector<GrainLines::Column> columns_of(const TableReader& table, const std::vector<GrainColumn>& quantities,
                                           const FileUnits& units, FileProblems& problems) {
  std::vector<GrainLines::Column> columns;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const auto& name = table.columns()[k];
    GrainLines::Column column{quantities[k], name.name};
    if (column.name.empty()) column.name = fmt::format("column {} (without a name)", k + 1);
    const bool twice =
        column.column != GrainColumn::none &&
        std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.column == column.column; });
    if (twice) problems.add(table.line_of_names(), fmt::format("{}: occurs twice", column.name));
    const auto factor = factor_of(name.unit, column.column, units);
    if (!factor) {
      problems.add(table.line_of_names(),
                   fmt::format("{}: the unit {} is unknown; use m, cm, mm, um, kg, g, m/s", column.name, name.unit));
    }
    column.factor = factor.value_or(1.0);
    columns.push_back(column);
  }
  return columns;
}

/// Refuses names that lack something, and says what may help.
void check_names(const TableReader& table, const std::vector<GrainColumn>& quantities, const ReaderOptions& options,
                 FileProblems& problems) {
  if (has_place_and_size(quantities, options)) return;
  const auto axes = axes_of(options.plane);
  auto what = fmt::format("must have the columns {}, {}, {}and radius or diameter", axes[0], axes[1],
                          options.in_space ? "z, " : "");
  for (const auto& [other, name] : {std::pair(Plane::xz, "xz"), std::pair(Plane::yz, "yz")}) {
    const bool helps =
        !options.in_space && options.plane == Plane::xy && has_place_and_size(quantities, {{.plane = other}});
    if (helps) {
      what += fmt::format("; for these set start.plane = \"{}\"", name);
      break;
    }
  }
  std::string names;
  for (const auto& column : table.columns()) names += (names.empty() ? "" : ", ") + shown(column.name);
  problems.stop(table.line_of_names(), fmt::format("{}; has {}", what, names));
}

}  // namespace

SeenFile read_grains_table(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  TableReader table(lines, problems, [&](const std::vector<ColumnName>& names) {
    return has_place_and_size(quantities_of(names), options);
  });
  const auto quantities = quantities_of(table.columns());
  check_names(table, quantities, options, problems);
  SeenFile file;
  file.format = "table";
  std::optional<GrainLines> grains;
  const auto begin = [&] {
    file.units = units_of(table.columns(), quantities);
    grains.emplace(problems, columns_of(table, quantities, file.units, problems), options);
  };
  while (table.next()) {
    if (!grains) begin();  // a row of units may have followed the names
    grains->read(table.line(), table.cells());
  }
  if (!grains) begin();
  grains->take(file);
  return file;
}

/// The first line is "#format x_y_z_r", which names the columns.
SeenFile read_yade_text(TextLines& lines, FileProblems& problems, const ReaderOptions& options) {
  std::string text;
  std::vector<std::string_view> cells;
  lines.next(text);
  split(text, blanks, cells);
  std::vector<GrainLines::Column> columns;
  const std::string format(cells.size() > 1 ? cells[1] : std::string_view());
  split(format, '_', cells);
  bool attributes = false;
  for (const auto& name : cells) {
    if (name == "attrs") {
      attributes = true;
    } else {
      columns.push_back({column_of(name).column, std::string(name)});
    }
  }
  std::vector<GrainColumn> quantities;
  for (const auto& column : columns) quantities.push_back(column.column);
  if (!has_place_and_size(quantities, options)) {
    problems.stop(1,
                  fmt::format("the format {} of YADE has no positions and radii; export it as x_y_z_r or x_y_z_r_matId",
                              shown(format)));
  }
  SeenFile file;
  file.format = "text export of YADE, " + format;
  const std::size_t known = columns.size();
  std::optional<GrainLines> grains;
  while (lines.next(text)) {
    split(text, blanks, cells);
    if (cells.empty()) continue;
    if (cells.front().starts_with('#')) {  // the last comment of x_y_z_r_attrs names the columns
      const bool names = attributes && cells.size() > known;
      for (std::size_t k = known; names && !grains && k < cells.size(); ++k)
        columns.push_back({{}, std::string(cells[k])});
      continue;
    }
    while (attributes && !grains && columns.size() < cells.size()) {
      columns.push_back({GrainColumn::none, fmt::format("attribute {}", columns.size() - known + 1)});
    }
    if (!grains) grains.emplace(problems, columns, options);
    grains->read(lines.number(), cells);
  }
  if (!grains) grains.emplace(problems, columns, options);
  grains->take(file);
  return file;
}

}  // namespace repose
