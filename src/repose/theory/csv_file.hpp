// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace repose::theory {

/// A CSV file, read as text. Empty lines and lines that begin with # are skipped. The first other line holds the names
/// of the columns; every further line is a row with one cell per column. A cell may stand in quotes; inside quotes a
/// comma is text and "" is a quote.
/// Validated by tests/theory/csv_file_test.cpp.
class CsvFile {
 public:
  /// Throws InputError ("file.csv:12: ...") if the file cannot be read, has no line of names, a name is missing or
  /// occurs twice, or a row has more or fewer cells than there are names.
  explicit CsvFile(const std::string& file);

  const std::string& file() const { return file_; }
  std::size_t rows() const { return rows_.size(); }
  std::size_t line(std::size_t row) const { return lines_[row]; }  ///< line number in the file, from 1
  bool has(const std::string& name) const;

  /// A column (rows,) of finite numbers. Throws InputError if it does not exist or a cell is not a finite number.
  std::vector<double> numbers(const std::string& name) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// The text of a cell for a CSV file: in quotes if it contains a comma, a quote or a line break.
std::string quoted(const std::string& cell);

/// Throws InputError with these problems, if there are any: the first 20, and the number of the rest.
void throw_if_any(std::vector<std::string> problems);

}  // namespace repose::theory
