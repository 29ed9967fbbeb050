// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/tables/cells.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace repose {

/// A table of numbers of which some columns are needed; table_reader.hpp describes the text. Names are compared without
/// regard to case and to the signs between their words.
/// Validated by tests/theory/table_test.cpp.
class NumberTable {
 public:
  /// Throws InputError ("file.csv:12: ...") if the file cannot be read, has no line of names, two columns have the same
  /// name, or a row has more or fewer cells than there are names. `needed` are names of columns by which the line of
  /// names is found.
  NumberTable(const std::string& file, const std::vector<std::string>& needed);

  const std::string& file() const { return file_; }
  std::size_t rows() const { return rows_.size(); }
  std::size_t line(std::size_t row) const { return lines_[row]; }  ///< line number in the file, from 1
  std::size_t columns() const { return columns_.size(); }
  std::string names() const;  ///< of all columns, "a, b"

  /// The number of the column with one of these names, the first of them that exists; none without one.
  std::optional<std::size_t> find(const std::vector<std::string>& names) const;
  const std::string& name(std::size_t column) const { return columns_[column].name; }
  const std::string& unit(std::size_t column) const { return columns_[column].unit; }

  /// A column (rows,) of finite numbers. Throws InputError if a cell is not a finite number.
  std::vector<double> numbers(std::size_t column) const;
  /// The column of this name. Throws InputError if there is none.
  std::vector<double> numbers(const std::string& name) const;

 private:
  std::string file_;
  std::vector<ColumnName> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

}  // namespace repose
