// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/errors.hpp"
#include "repose/io/column_values.hpp"
#include "repose/io/hdf5_file.hpp"
#include "repose/io/hdf5_reader.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// One list of columns says all that there is to say of a table: it writes HDF5, reads it back and prints the reference.
// Everything that reads HDF5 files (CSV export, Python) has unit and meaning from there.

namespace repose {

/// A dataset of a group, made from a `From`: most often from rows, a std::vector<Row>, of which it is a column.
template <class From>
struct Column {
  std::string name;
  std::string unit;
  std::string meaning;
  std::string columns;    ///< number of columns of a dataset with two dimensions, or the letter for it; else ""
  std::string_view type;  ///< as the reference names it; "" is double
  std::function<void(Hdf5File&, const std::string& path, const From&)> write;
  /// Gives the values back and returns how many rows the file has. Empty where they follow from other columns.
  std::function<std::size_t(const Hdf5Reader&, const std::string& path, From&)> read = {};
  std::string rows = {};  ///< letter for the number of rows in the reference, where it is not that of the group
  bool optional = false;  ///< a file may lack it: reading leaves the values as they are
};

template <class From>
using Columns = std::vector<Column<From>>;

/// A column of rows. `entry` is a member of Row, or a function that gives a number, a text, a Vec, an array, or
/// std::tie of members. The column is read back where that refers to the row itself.
template <class Row, class Entry>
Column<std::vector<Row>> column(const std::string& name, Entry entry, const std::string& unit,
                                const std::string& meaning) {
  using Rows = std::vector<Row>;
  using Value = std::remove_cvref_t<std::invoke_result_t<const Entry&, const Row&>>;
  using Kept = KeptAs<Value>;
  constexpr auto width = width_of<Value>;
  Column<Rows> made{name, unit, meaning, width == 1 ? "" : std::to_string(width), type_name<Kept>, {}};
  made.write = [=](Hdf5File& file, const std::string& path, const Rows& rows) {
    std::vector<Kept> values;
    values.reserve(rows.size() * width);
    for (const auto& row : rows) append_parts(values, std::invoke(entry, row));
    write_values(file, path, values, width, unit, meaning);
  };
  if constexpr (refers_to_row<std::invoke_result_t<const Entry&, Row&>>) {
    made.read = [=](const Hdf5Reader& file, const std::string& path, Rows& rows) {
      const auto values = read_values<Kept>(file, path, width);
      const auto count = values.size() / width;
      if (rows.empty()) rows.resize(count);
      if (rows.size() != count) return count;
      for (std::size_t k = 0; k < count; ++k) assign_parts(std::invoke(entry, rows[k]), &values[k * width]);
      return count;
    };
  }
  return made;
}

template <class Row, class Value>
Column<std::vector<Row>> column(const std::string& name, Value Row::*member, const std::string& unit,
                                const std::string& meaning) {
  return column<Row, Value Row::*>(name, member, unit, meaning);
}

/// A column as a larger object writes it: `part` gives what the column is made from.
template <class From, class Part, class Get>
Column<From> column_of(const Column<Part>& column, Get part) {
  Column<From> made{column.name, column.unit, column.meaning, column.columns, column.type,
                    {},          {},          column.rows,    column.optional};
  made.write = [=](Hdf5File& file, const std::string& path, const From& from) {
    column.write(file, path, std::invoke(part, from));
  };
  if constexpr (std::is_same_v<std::invoke_result_t<const Get&, From&>, Part&>) {
    if (column.read) {
      made.read = [=](const Hdf5Reader& file, const std::string& path, From& from) {
        return column.read(file, path, std::invoke(part, from));
      };
    }
  }
  return made;
}

template <class From, class Part, class Get>
Columns<From> columns_of(const Columns<Part>& columns, Get part) {
  Columns<From> made;
  for (const auto& column : columns) made.push_back(column_of<From>(column, part));
  return made;
}

/// A whole dataset: `entry` is a member of From, or a function of it, that gives a std::vector.
template <class From, class Entry>
Column<From> array(const std::string& name, Entry entry, const std::string& unit, const std::string& meaning) {
  using Row = typename std::remove_cvref_t<std::invoke_result_t<const Entry&, const From&>>::value_type;
  const auto itself = [](auto& value) -> auto& { return value; };
  return column_of<From>(column<Row>(name, itself, unit, meaning), entry);
}

template <class From, class Row>
Column<From> array(const std::string& name, std::vector<Row> From::*member, const std::string& unit,
                   const std::string& meaning) {
  return array<From, std::vector<Row> From::*>(name, member, unit, meaning);
}

/// The column, which a file may lack.
template <class From>
Column<From> optional(Column<From> column) {
  column.optional = true;
  return column;
}

/// The column, with as many rows as the letter says.
template <class From>
Column<From> with_rows(const std::string& rows, Column<From> column) {
  column.rows = rows;
  return column;
}

/// Values row by row.
struct Matrix {
  const std::vector<double>& values;
  std::size_t columns;
};

/// A whole dataset with as many columns, by the letter for it in the reference, as the Matrix that `entry` gives.
template <class From, class Entry>
Column<From> matrix(const std::string& name, const std::string& letter, Entry entry, const std::string& unit,
                    const std::string& meaning) {
  Column<From> made{name, unit, meaning, letter, type_name<double>, {}};
  made.write = [=](Hdf5File& file, const std::string& path, const From& from) {
    const Matrix matrix = std::invoke(entry, from);
    file.table(path, matrix.values, matrix.columns, unit, meaning);
  };
  return made;
}

template <class From>
void write_columns(Hdf5File& file, const std::string& group, const Columns<From>& columns, const From& from) {
  for (const auto& column : columns) column.write(file, group + "/" + column.name, from);
}

/// The same for rows that are not all in memory. Each call of `for_each(use)` calls use(block) with block after block,
/// none of them empty, or with an empty one if there are no rows. Not for texts.
template <class Row, class ForEach>
void write_columns_in_blocks(Hdf5File& file, const std::string& group, const Columns<std::vector<Row>>& columns,
                             std::size_t rows, const ForEach& for_each) {
  for (const auto& column : columns) {
    file.expect_blocks(rows);
    for_each([&](const std::vector<Row>& block) { column.write(file, group + "/" + column.name, block); });
  }
}

/// Throws InputError where a column is missing that older programs wrote too, or where one is not as long as the others
/// and `rows`.
template <class From>
void read_columns(const Hdf5Reader& file, const std::string& group, const Columns<From>& columns, From& from,
                  std::optional<std::size_t> rows = std::nullopt) {
  for (const auto& column : columns) {
    if (!column.read || (column.optional && !file.has(group + "/" + column.name))) continue;
    const auto found = column.read(file, group + "/" + column.name, from);
    if (found != rows.value_or(found)) throw InputError(file.path() + ": " + group + ": the datasets differ in length");
    rows = found;
  }
}

}  // namespace repose
