// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose::theory {

/// A column of a table: numbers, or words where `words` is not empty.
struct Column {
  std::string name;   ///< as in the line of names of a CSV file
  std::string unit;   ///< "1" for a pure number, "" for words
  std::string about;  ///< one line
  std::vector<double> values;
  std::vector<std::string> words;
};

/// A result that is one number; not-a-number where it is not defined.
struct Number {
  std::string name;
  double value;
  std::string unit;
  std::string about;
};

/// What a model predicts: columns of one length, and single numbers.
struct Table {
  std::vector<Column> columns;
  std::vector<Number> numbers;

  /// The column or number of a name that must be there.
  const Column& column(const std::string& name) const;
  double number(const std::string& name) const;
  bool has_column(const std::string& name) const;
};

}  // namespace repose::theory
