// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/groups.hpp"

#include <string>
#include <vector>

namespace repose {

/// A table of a page of docs/reference.
struct ReferenceTable {
  std::string name;  ///< by which the page holds its place
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// Markdown between two comments, the first with the name of the table.
std::string markdown_of(const ReferenceTable& table);
std::string markdown_of(const std::vector<ReferenceTable>& tables);

/// Shape and type of a dataset: "(N, 2) uint8".
std::string shape_text(const std::string& rows, const std::string& columns, std::string_view type);

/// The attributes of a group, named "GROUP attributes".
template <class From>
ReferenceTable reference_of(const std::string& group, const Attributes<From>& attributes) {
  ReferenceTable table{group + " attributes", {"attribute", "unit", "meaning"}, {}};
  for (const auto& one : attributes) table.rows.push_back({"`" + one.name + "`", one.unit, one.meaning});
  return table;
}

/// Datasets, with the path of their group in front of their names.
template <class From>
ReferenceTable reference_of(const std::string& name, const std::string& path, const std::string& rows,
                            const Columns<From>& columns) {
  ReferenceTable table{name, {"dataset", "shape", "unit", "meaning"}, {}};
  for (const auto& one : columns) {
    table.rows.push_back({"`" + path + one.name + "`",
                          shape_text(one.rows.empty() ? rows : one.rows, one.columns, one.type), one.unit,
                          one.meaning});
  }
  return table;
}

/// Attributes, if the group has any, and datasets, without path.
template <class From>
std::vector<ReferenceTable> reference_of(const Group<From>& group) {
  std::vector<ReferenceTable> tables;
  if (!group.attributes.empty()) tables.push_back(reference_of(group.name, group.attributes));
  if (!group.columns.empty()) tables.push_back(reference_of(group.name, "", group.rows, group.columns));
  return tables;
}

}  // namespace repose
