// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/reference.hpp"

#include "repose/results/analysis_file.hpp"
#include "repose/results/registry.hpp"

#include <algorithm>

namespace repose {

namespace {

std::string where(const KnownMeasure& measure) {
  switch (measure.needs) {
    case Needs::nothing:
      return "";
    case Needs::forces:
      return "methods with forces";
    case Needs::collisions:
      return "methods with hard collisions";
    case Needs::solver:
      return "methods with a solver";
    case Needs::deposition:
      return "deposition";
  }
  return "";
}

std::string key_text(const KnownMeasure& measure) {
  const auto key = "`" + measure.name + "`";
  return measure.kind == KnownMeasure::Kind::estimate ? key + ": `mean`, `error`" : key;
}

}  // namespace

namespace {

template <int D>
ReferenceTable table_of_measures(const std::string& name) {
  ReferenceTable table{name, {"key", "unit", "meaning", "defined for"}, {}};
  for (const auto& measure : measures<D>()) {
    table.rows.push_back({key_text(measure), measure.unit, measure.meaning, where(measure)});
  }
  return table;
}

/// Adds the tables of groups; those of a group that others add to are one. `of` stands behind their names.
template <int D>
void add_groups(const std::string& of, std::vector<ReferenceTable>& tables) {
  for (const auto& group : analysis_groups<D>()) {
    for (auto table : group.reference) {
      table.name += of;
      const auto same = [&](const ReferenceTable& other) { return other.name == table.name; };
      if (const auto found = std::find_if(tables.begin(), tables.end(), same); found != tables.end()) {
        found->rows.insert(found->rows.end(), table.rows.begin(), table.rows.end());
      } else {
        tables.push_back(table);
      }
    }
  }
}

}  // namespace

std::vector<ReferenceTable> summary_reference() {
  return {table_of_measures<2>("summary"), table_of_measures<3>("summary of spheres")};
}

std::vector<ReferenceTable> analysis_reference() {
  auto tables = reference_of(measure_group());
  add_groups<2>("", tables);
  add_groups<3>(" of spheres", tables);
  return tables;
}

}  // namespace repose
