// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/tables/cells.hpp"
#include "repose/tables/file_problems.hpp"
#include "repose/tables/text_lines.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

/// Reads a table of text: a line of names, then a line for each row. Cells are separated by semicolons, tabs, commas or
/// blanks, and may stand in quotes. Lines that begin with # or % are comments; the names may stand in the last comment
/// above the numbers. Lines above the names are skipped. A separator at the end of the lines, and a column of row names
/// without a name of its own (pandas, R), are no problem. A row of units may follow the names.
/// Validated by tests/theory/table_test.cpp and tests/unit/grains_file_test.cpp.
class TableReader {
 public:
  /// Whether these are the names of the table: they hold what is needed of it.
  using Suffices = std::function<bool(const std::vector<ColumnName>&)>;

  /// Reads up to the names. If no line suffices, columns() are those of the line that comes nearest; without any such
  /// line it throws InputError.
  TableReader(TextLines& lines, FileProblems& problems, const Suffices& suffices);

  const std::vector<ColumnName>& columns() const { return columns_; }
  std::size_t line_of_names() const { return line_of_names_; }

  /// The next row, with as many cells as there are columns; false at the end. Adds a problem for each row that has more
  /// or fewer, and leaves it out.
  bool next();
  const std::vector<std::string_view>& cells() const { return cells_; }
  std::size_t line() const { return line_; }

 private:
  void find_names(const Suffices& suffices);
  void take_names(std::string_view text, std::size_t line);
  bool next_line();
  bool has_right_cells(char separator);
  bool has_units();
  void split_row();

  TextLines& lines_;
  FileProblems& problems_;
  std::vector<ColumnName> columns_;
  std::size_t line_of_names_ = 0;
  std::optional<char> separator_;  // of the rows, once the first has been read
  char separator_of_names_ = ',';
  bool row_names_ = false;  // the rows begin with a name that the head lacks
  bool pending_ = false;    // text_ is a row that has not been used
  bool first_row_ = true;
  std::string text_;
  std::size_t line_ = 0;
  std::vector<std::string_view> cells_;
};

}  // namespace repose
