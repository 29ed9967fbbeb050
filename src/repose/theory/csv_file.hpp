// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace repose::theory {

/// A CSV file as text: empty lines and lines that begin with # are skipped, the first other line has the names, then
/// come rows of as many cells. Cells may stand in quotes, within which a comma is text and "" a quote.
/// Validated by tests/theory/csv_file_test.cpp.
class CsvFile {
 public:
  /// Throws InputError where the file cannot be read, has no line of names, names a column twice or not at all, or a
  /// row has more or fewer cells ("file.csv:12: ...").
  explicit CsvFile(const std::string& file);

  const std::string& file() const { return file_; }
  std::size_t rows() const { return rows_.size(); }
  std::size_t line(std::size_t row) const { return lines_[row]; }  ///< as an editor counts, from 1
  bool has(const std::string& name) const;

  /// A column (rows,) of finite numbers. Throws InputError where there is no such column or a cell is no number.
  std::vector<double> numbers(const std::string& name) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// A cell as CsvFile reads it back: in quotes where it has a comma, a quote or a line break.
std::string quoted(const std::string& cell);

/// Throws InputError with these problems, of many the first and how many more there are; does nothing without any.
void throw_if_any(std::vector<std::string> problems);

}  // namespace repose::theory
