// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/table.hpp"

#include <algorithm>
#include <stdexcept>

namespace repose::theory {

namespace {

template <class Entry>
const Entry& named(const std::vector<Entry>& entries, const std::string& name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  if (found == entries.end()) throw std::out_of_range("a table of theory has no " + name);
  return *found;
}

}  // namespace

const Column& Table::column(const std::string& name) const { return named(columns, name); }

double Table::number(const std::string& name) const { return named(numbers, name).value; }

bool Table::has_column(const std::string& name) const {
  return std::ranges::find(columns, name, &Column::name) != columns.end();
}

}  // namespace repose::theory
