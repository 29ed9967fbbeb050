// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/grains_file.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

namespace repose {

namespace {

/// Our name of a column, or "" for one that says nothing of a grain. Our own tables, LAMMPS and people name them
/// differently.
std::string column_of(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> names = {{"x", "x"},
                                                                         {"position_x", "x"},
                                                                         {"y", "y"},
                                                                         {"position_y", "y"},
                                                                         {"vx", "vx"},
                                                                         {"velocity_x", "vx"},
                                                                         {"vy", "vy"},
                                                                         {"velocity_y", "vy"},
                                                                         {"spin", "spin"},
                                                                         {"omegaz", "spin"},
                                                                         {"radius", "radius"},
                                                                         {"diameter", "diameter"},
                                                                         {"mass", "mass"},
                                                                         {"fixed", "fixed"},
                                                                         {"base", "base"},
                                                                         {"id", "id"},
                                                                         {"material", "material"},
                                                                         {"type", "type"}};
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  return found == names.end() ? "" : found->second;
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::string cell; std::getline(in, cell, separator);) {
    while (!cell.empty() && blank(cell.back())) cell.pop_back();
    while (!cell.empty() && blank(cell.front())) cell.erase(0, 1);
    if (separator != ' ' || !cell.empty()) cells.push_back(cell);
  }
  return cells;
}

class GrainsFile {
 public:
  explicit GrainsFile(std::string path) : path_(std::move(path)) {}

  std::vector<GrainRow> read() {
    std::ifstream in(path_);
    if (!in) throw InputError(fmt::format("{}: cannot be read", path_));
    constexpr std::size_t most_problems = 20;
    for (std::string text; std::getline(in, text) && problems_.size() < most_problems;) {
      ++line_;
      if (text.starts_with("ITEM:")) {
        begin_item(text);
      } else if (dump_) {
        if (atoms_) read_row(cells_of(text, ' '));
      } else {
        read_line_of_table(text);
      }
    }
    if (columns_.empty() && problems_.empty()) problems_.push_back(fmt::format("{}: no line with names", path_));
    if (rows_.empty() && problems_.empty()) problems_.push_back(fmt::format("{}: no grains", path_));
    if (!problems_.empty()) throw InputError(problems_);
    return rows_;
  }

 private:
  void problem(const std::string& what) { problems_.push_back(fmt::format("{}:{}: {}", path_, line_, what)); }

  bool has(const std::string& name) const {
    return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
  }

  /// A part of a LAMMPS dump. Of several moments the last counts.
  void begin_item(const std::string& text) {
    const std::string atoms = "ITEM: ATOMS";
    dump_ = true;
    atoms_ = text.starts_with(atoms);
    if (!atoms_) return;
    rows_.clear();
    columns_.clear();
    for (const auto& name : cells_of(text.substr(atoms.size()), ' ')) columns_.push_back(column_of(name));
    check_columns();
  }

  void read_line_of_table(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos || text[begin] == '#') return;
    const auto cells = cells_of(text, ',');
    if (!columns_.empty()) return read_row(cells);
    for (const auto& name : cells) {
      columns_.push_back(column_of(name));
      if (columns_.back().empty()) {
        problem(
            fmt::format("{}: unknown column; known are id, x, y, radius or diameter, vx, vy, spin, mass, material, "
                        "fixed, base",
                        name));
      }
    }
    check_columns();
  }

  void check_columns() {
    for (const auto& name : columns_) {
      if (!name.empty() && std::count(columns_.begin(), columns_.end(), name) > 1) {
        return problem(fmt::format("{}: is there twice", name));
      }
    }
    if (!has("x") || !has("y") || has("radius") == has("diameter")) {
      problem("must have the columns x, y, and either radius or diameter");
    }
  }

  void read_row(const std::vector<std::string>& cells) {
    if (cells.size() != columns_.size()) {
      return problem(fmt::format("has {} values; must have {}", cells.size(), columns_.size()));
    }
    GrainRow row;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& name = columns_[k];
      if (name.empty()) continue;
      const auto& cell = cells[k];
      double value = 0.0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        return problem(fmt::format("{} = {}: must be a finite number", name, cell));
      }
      if (const auto wrong = set(row, name, value); !wrong.empty()) {
        return problem(fmt::format("{} = {}: {}", name, cell, wrong));
      }
    }
    if (row.base && !row.fixed) return problem("base = 1: a grain of the base must be fixed");
    rows_.push_back(row);
  }

  /// Fills a value in; says what is allowed if it is none.
  static std::string set(GrainRow& row, const std::string& name, double value) {
    if (name == "radius" || name == "diameter" || name == "mass") {
      if (value <= 0.0) return "must be > 0";
      if (name == "mass") row.mass = value;
      if (name == "radius") row.radius = value;
      if (name == "diameter") row.radius = 0.5 * value;
    } else if (name == "fixed" || name == "base") {
      if (value != 0.0 && value != 1.0) return "must be 0 or 1";
      (name == "fixed" ? row.fixed : row.base) = value == 1.0;
    } else if (name == "id" || name == "material" || name == "type") {
      const double low = name == "type" ? 1.0 : 0.0;
      const double high = name == "id" ? 0x1p53 : 65535.0;
      if (value != std::floor(value) || value < low || value > high) {
        return fmt::format("must be a whole number from {} to {}", low, high);
      }
      if (name == "id") row.id = static_cast<std::int64_t>(value);
      // Types of LAMMPS count from 1.
      if (name != "id") row.material = static_cast<std::uint16_t>(value - low);
    } else {
      if (name == "x") row.position[0] = value;
      if (name == "y") row.position[1] = value;
      if (name == "vx") row.velocity[0] = value;
      if (name == "vy") row.velocity[1] = value;
      if (name == "spin") row.spin = value;
    }
    return {};
  }

  std::string path_;
  std::size_t line_ = 0;
  bool dump_ = false;   // a LAMMPS dump, not a table
  bool atoms_ = false;  // in its list of atoms
  std::vector<std::string> columns_;
  std::vector<GrainRow> rows_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<GrainRow> read_grains_file(const std::string& path) { return GrainsFile(path).read(); }

}  // namespace repose
