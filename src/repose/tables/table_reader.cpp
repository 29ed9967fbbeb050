// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/tables/table_reader.hpp"

#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

constexpr const char* blank_signs = " \t\r";

/// The text of a comment; none if the line is no comment.
std::optional<std::string_view> comment_in(std::string_view line) {
  const auto begin = line.find_first_not_of(blank_signs);
  if (begin == std::string_view::npos) return std::nullopt;
  const auto text = line.substr(begin);
  const auto sign = text.front();
  const bool marked = sign == '#' || sign == '%' || sign == '!' || text.starts_with("//") || text.starts_with("; ");
  if (!marked) return std::nullopt;
  const auto end = text.find_first_not_of("#%!/; \t");
  return end == std::string_view::npos ? std::string_view() : text.substr(end);
}

/// Whether a line says nothing: it is blank, or a rule of dashes under the names.
bool blank(std::string_view line) { return line.find_first_not_of(" \t\r-=_+|") == std::string_view::npos; }

/// Whether a line holds values, not names: at least half of its cells are numbers, by some separator.
bool has_numbers(std::string_view line) {
  std::vector<std::string_view> cells;
  for (const char separator : {';', '\t', ',', blanks}) {
    split(line, separator, cells);
    const auto numbers =
        std::count_if(cells.begin(), cells.end(), [](auto cell) { return number_of(cell).has_value(); });
    if (numbers > 0 && 2 * numbers >= static_cast<std::ptrdiff_t>(cells.size())) return true;
  }
  return false;
}

}  // namespace

TableReader::TableReader(TextLines& lines, FileProblems& problems, const Suffices& suffices)
    : lines_(lines), problems_(problems) {
  find_names(suffices);
}

void TableReader::find_names(const Suffices& suffices) {
  struct Line {
    std::string text;
    std::size_t number;
  };
  std::optional<Line> found;    // the last comment that suffices
  std::optional<Line> nearest;  // the last other line above the numbers
  std::size_t skipped = 0;
  constexpr std::size_t most_skipped = 1000;
  const auto names_in = [](std::string_view text) { return column_names(text, separator_of_names(text)); };
  while (lines_.next(text_)) {
    line_ = lines_.number();
    if (blank(text_)) continue;
    if (const auto comment = comment_in(text_)) {
      if (suffices(names_in(*comment))) found = Line{std::string(*comment), line_};
      continue;
    }
    if (suffices(names_in(text_))) return take_names(text_, line_);
    if (found || has_numbers(text_) || ++skipped > most_skipped) {
      pending_ = true;
      break;
    }
    nearest = Line{text_, line_};
  }
  if (found) return take_names(found->text, found->number);
  if (nearest) return take_names(nearest->text, nearest->number);
  if (pending_) problems_.stop(line_, "must be the names of the columns, above the numbers");
  throw InputError(fmt::format("{}: is empty: no line with the names of the columns", problems_.path()));
}

void TableReader::take_names(std::string_view text, std::size_t line) {
  separator_of_names_ = separator_of_names(text);
  columns_ = column_names(text, separator_of_names_);
  line_of_names_ = line;
  while (columns_.size() > 1 && columns_.back().name.empty()) columns_.pop_back();
}

/// Puts the next line that is neither blank nor a comment into text_.
bool TableReader::next_line() {
  if (pending_) {
    pending_ = false;
    return true;
  }
  while (lines_.next(text_)) {
    line_ = lines_.number();
    if (!blank(text_) && !comment_in(text_)) return true;
  }
  return false;
}

/// Splits the line by a separator. Whether it then has as many cells as there are columns, none of which holds another
/// separator.
bool TableReader::has_right_cells(char separator) {
  split(text_, separator, cells_);
  while (cells_.size() > columns_.size() && cells_.back().empty()) cells_.pop_back();
  const bool clean = separator != blanks || std::none_of(cells_.begin(), cells_.end(), [](auto cell) {
                       return cell.starts_with(',') || cell.ends_with(',') || cell.find(';') != std::string_view::npos;
                     });
  return clean && cells_.size() == columns_.size();
}

/// Whether the cells are units of the columns: takes them.
bool TableReader::has_units() {
  std::vector<std::string> units;
  for (auto cell : cells_) {
    const bool bracketed =
        cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
    if (bracketed) cell = trimmed(cell.substr(1, cell.size() - 2));
    if (number_of(cell) || (!bracketed && !cell.empty() && !is_unit(cell))) return false;
    units.emplace_back(cell);
  }
  if (std::all_of(units.begin(), units.end(), [](const auto& unit) { return unit.empty(); })) return false;
  for (std::size_t k = 0; k < units.size() && k < columns_.size(); ++k) {
    if (!units[k].empty()) columns_[k].unit = units[k];
  }
  return true;
}

/// Splits a row; the first one decides on the separator.
void TableReader::split_row() {
  if (!separator_) {
    for (const char separator : {separator_of_names_, ';', '\t', ',', blanks}) {
      if (!separator_ && has_right_cells(separator)) separator_ = separator;
    }
    if (!separator_) {
      separator_ = separator_of_names_;
      split(text_, *separator_, cells_);
      const auto quote = text_.find_first_not_of(blank_signs);
      row_names_ = cells_.size() == columns_.size() + 1 && !cells_.back().empty() && text_[quote] == '"';
    }
  }
  split(text_, *separator_, cells_);
  if (row_names_ && cells_.size() == columns_.size() + 1) cells_.erase(cells_.begin());
  while (cells_.size() > columns_.size() && cells_.back().empty()) cells_.pop_back();
}

bool TableReader::next() {
  while (next_line()) {
    split_row();
    const bool first = std::exchange(first_row_, false);
    if (cells_.size() == columns_.size()) {
      if (first && has_units()) continue;
      return true;
    }
    problems_.add(line_, fmt::format("has {} value{}; must have {}", cells_.size(), cells_.size() == 1 ? "" : "s",
                                     columns_.size()));
  }
  return false;
}

}  // namespace repose
