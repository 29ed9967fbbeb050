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

namespace repose {

namespace {

const std::vector<std::string> known = {"x", "y", "radius", "diameter", "vx", "vy", "spin", "fixed"};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    const auto begin = cell.find_first_not_of(" \t\r");
    const auto end = cell.find_last_not_of(" \t\r");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

class Table {
 public:
  explicit Table(std::string path) : path_(std::move(path)) {}

  std::vector<GrainRow> read() {
    std::ifstream in(path_);
    if (!in) throw InputError(fmt::format("{}: cannot be read", path_));
    std::vector<GrainRow> rows;
    constexpr std::size_t most_problems = 20;
    for (std::string text; std::getline(in, text) && problems_.size() < most_problems;) {
      ++line_;
      const auto begin = text.find_first_not_of(" \t\r");
      if (begin == std::string::npos || text[begin] == '#') continue;
      if (columns_.empty()) {
        read_header(cells_of(text));
      } else {
        read_row(cells_of(text), rows);
      }
    }
    if (columns_.empty() && problems_.empty()) problems_.push_back(fmt::format("{}: no line with names", path_));
    if (rows.empty() && problems_.empty()) problems_.push_back(fmt::format("{}: no grains", path_));
    if (!problems_.empty()) throw InputError(problems_);
    return rows;
  }

 private:
  void problem(const std::string& what) { problems_.push_back(fmt::format("{}:{}: {}", path_, line_, what)); }

  void read_header(const std::vector<std::string>& names) {
    columns_ = names;
    for (const auto& name : names) {
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        problem(fmt::format("{}: unknown column; known are x, y, radius or diameter, vx, vy, spin, fixed", name));
      }
      if (std::count(names.begin(), names.end(), name) > 1) problem(fmt::format("{}: is there twice", name));
    }
    if (!has("x") || !has("y") || has("radius") == has("diameter")) {
      problem("must have the columns x, y, and either radius or diameter");
    }
  }

  bool has(const std::string& name) const {
    return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
  }

  void read_row(const std::vector<std::string>& cells, std::vector<GrainRow>& rows) {
    if (cells.size() != columns_.size()) {
      return problem(fmt::format("has {} values; must have {}", cells.size(), columns_.size()));
    }
    GrainRow row;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& name = columns_[k];
      const auto& cell = cells[k];
      double value = 0.0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        return problem(fmt::format("{} = {}: must be a finite number", name, cell));
      }
      if ((name == "radius" || name == "diameter") && value <= 0.0) {
        return problem(fmt::format("{} = {}: must be > 0 [L]", name, cell));
      }
      if (name == "fixed" && value != 0.0 && value != 1.0) {
        return problem(fmt::format("fixed = {}: must be 0 or 1", cell));
      }
      set(row, name, value);
    }
    rows.push_back(row);
  }

  static void set(GrainRow& row, const std::string& name, double value) {
    if (name == "x") row.position[0] = value;
    if (name == "y") row.position[1] = value;
    if (name == "vx") row.velocity[0] = value;
    if (name == "vy") row.velocity[1] = value;
    if (name == "spin") row.spin = value;
    if (name == "radius") row.radius = value;
    if (name == "diameter") row.radius = 0.5 * value;
    if (name == "fixed") row.fixed = value == 1.0;
  }

  std::string path_;
  std::size_t line_ = 0;
  std::vector<std::string> columns_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<GrainRow> read_grains_file(const std::string& path) { return Table(path).read(); }

}  // namespace repose
