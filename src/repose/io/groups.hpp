// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/attributes.hpp"
#include "repose/io/columns.hpp"

#include <optional>
#include <string>

namespace repose {

/// A group of a file, made from a `From`.
template <class From>
struct Group {
  std::string name;
  std::string rows;  ///< letter for the number of rows in the reference
  Attributes<From> attributes;
  Columns<From> columns;
};

template <class From>
void write_group(Hdf5File& file, const Group<From>& group, const From& from) {
  file.group(group.name);
  write_attributes(file, group.name, group.attributes, from);
  write_columns(file, group.name, group.columns, from);
}

/// Throws InputError where something is missing or differs in length.
template <class From>
void read_group(const Hdf5Reader& file, const Group<From>& group, From& from,
                std::optional<std::size_t> rows = std::nullopt) {
  read_attributes(file, group.name, group.attributes, from);
  read_columns(file, group.name, group.columns, from, rows);
}

}  // namespace repose
