// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/tables/number_table.hpp"

#include "repose/core/errors.hpp"
#include "repose/tables/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace repose {

NumberTable::NumberTable(const std::string& file, const std::vector<std::string>& needed) : file_(file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError(fmt::format("{}: no such file", file));
  if (std::filesystem::is_directory(file, error)) throw InputError(fmt::format("{}: is a folder", file));
  FileProblems problems(file);
  TextLines lines(file);
  TableReader table(lines, problems, [&](const std::vector<ColumnName>& columns) {
    return std::all_of(needed.begin(), needed.end(), [&](const auto& name) {
      return std::any_of(columns.begin(), columns.end(),
                         [&](const auto& column) { return plain_name(column.name) == plain_name(name); });
    });
  });
  while (table.next()) {
    rows_.emplace_back(table.cells().begin(), table.cells().end());
    lines_.push_back(table.line());
  }
  columns_ = table.columns();
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    for (std::size_t before = 0; before < k; ++before) {
      const auto name = plain_name(columns_[k].name);
      if (!name.empty() && name == plain_name(columns_[before].name)) {
        problems.add(table.line_of_names(), fmt::format("{}: occurs twice", columns_[k].name));
      }
    }
  }
  problems.check();
}

std::string NumberTable::names() const {
  std::vector<std::string> names;
  for (const auto& column : columns_) names.push_back(column.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<std::size_t> NumberTable::find(const std::vector<std::string>& names) const {
  for (const auto& name : names) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (plain_name(columns_[k].name) == plain_name(name)) return k;
    }
  }
  return std::nullopt;
}

std::vector<double> NumberTable::numbers(std::size_t column) const {
  FileProblems problems(file_);
  std::vector<double> values;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const auto& cell = rows_[row][column];
    const auto value = number_of(cell);
    if (!value) {
      problems.add(lines_[row], fmt::format("{} = {}: is not a finite number", columns_[column].name, shown(cell)));
    }
    values.push_back(value.value_or(0.0));
  }
  problems.check();
  return values;
}

std::vector<double> NumberTable::numbers(const std::string& name) const {
  const auto column = find({name});
  if (!column) throw InputError(fmt::format("{}: has no column {}; has {}", file_, name, names()));
  return numbers(*column);
}

}  // namespace repose
