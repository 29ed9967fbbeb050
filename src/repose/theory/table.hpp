// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace repose::theory {

/// A column of a table: numbers, or words if `words` is not empty.
struct Column {
  std::string name;   ///< as in the header of a CSV file
  std::string unit;   ///< "1" for a pure number, "" for words
  std::string about;  ///< one line
  std::vector<double> values;
  std::vector<std::string> words;
};

/// A result that is a single number; NaN if undefined.
struct Number {
  std::string name;
  double value;
  std::string unit;
  std::string about;
};

/// The prediction of a model: columns of equal length, and single numbers.
struct Table {
  std::vector<Column> columns;
  std::vector<Number> numbers;
  std::vector<std::string> notes{};  ///< on the data that the prediction used, one line each

  /// The column or number of this name. Throws std::out_of_range if there is none.
  const Column& column(const std::string& name) const;
  double number(const std::string& name) const;
  bool has_column(const std::string& name) const;
};

}  // namespace repose::theory
