// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/csv_file.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

namespace repose::theory {

namespace {

constexpr std::size_t most_problems = 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
        cell += '"';
        ++i;
      } else {
        quoted = !quoted;
      }
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back(trimmed(cell));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  cells.emplace_back(trimmed(cell));
  return cells;
}

bool is_finite_number(const std::string& cell, double& value) {
  const char* end = cell.data() + cell.size();
  const char* begin = cell.starts_with('+') ? cell.data() + 1 : cell.data();
  const auto result = std::from_chars(begin, end, value);
  return result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
}

}  // namespace

CsvFile::CsvFile(const std::string& file) : file_(file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError(fmt::format("{}: no such file", file));
  if (std::filesystem::is_directory(file, error)) throw InputError(fmt::format("{}: is a folder", file));
  std::ifstream stream{file};
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file));
  std::vector<std::string> problems;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    const auto text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    auto cells = cells_of(text);
    if (names_.empty()) {
      names_ = std::move(cells);
      const std::set<std::string> different(names_.begin(), names_.end());
      if (different.contains("")) problems.push_back(fmt::format("{}:{}: a column has no name", file, number));
      if (different.size() < names_.size()) {
        problems.push_back(fmt::format("{}:{}: two columns have the same name", file, number));
      }
    } else if (cells.size() != names_.size()) {
      problems.push_back(fmt::format("{}:{}: has {} cell{}, the line of names has {}", file, number, cells.size(),
                                     cells.size() == 1 ? "" : "s", names_.size()));
    } else {
      rows_.push_back(std::move(cells));
      lines_.push_back(number);
    }
  }
  if (stream.bad()) throw InputError(fmt::format("{}: cannot be read", file));
  if (names_.empty()) problems.push_back(fmt::format("{}: has no line of names", file));
  throw_if_any(std::move(problems));
}

bool CsvFile::has(const std::string& name) const { return std::ranges::find(names_, name) != names_.end(); }

std::vector<double> CsvFile::numbers(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) {
    throw InputError(fmt::format("{}: has no column {}; has {}", file_, name, fmt::join(names_, ", ")));
  }
  const auto column = static_cast<std::size_t>(found - names_.begin());
  std::vector<double> values;
  std::vector<std::string> problems;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const auto& cell = rows_[row][column];
    double value = 0.0;
    if (!is_finite_number(cell, value)) {
      problems.push_back(fmt::format("{}:{}: {} = {}: is not a finite number", file_, lines_[row], name, cell));
    }
    values.push_back(value);
  }
  throw_if_any(std::move(problems));
  return values;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string all = "\"";
  for (const char c : cell) all += c == '"' ? std::string{"\"\""} : std::string{c};
  return all + "\"";
}

void throw_if_any(std::vector<std::string> problems) {
  if (problems.empty()) return;
  if (problems.size() > most_problems) {
    const auto more = problems.size() - most_problems;
    problems.resize(most_problems);
    problems.push_back(fmt::format("and {} more like these", more));
  }
  throw InputError(problems);
}

}  // namespace repose::theory
