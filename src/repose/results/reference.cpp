// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/reference.hpp"

#include "repose/results/analysis_file.hpp"
#include "repose/results/registry.hpp"

#include <algorithm>

namespace repose {

namespace {

std::string where(const Measure& measure) {
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

std::string key_text(const Measure& measure) {
  const auto key = "`" + measure.name + "`";
  return measure.kind == Measure::Kind::estimate ? key + ": `mean`, `error`" : key;
}

}  // namespace

std::vector<ReferenceTable> summary_reference() {
  ReferenceTable table{"summary", {"key", "unit", "meaning", "defined for"}, {}};
  for (const auto& measure : measures()) {
    table.rows.push_back({key_text(measure), measure.unit, measure.meaning, where(measure)});
  }
  return {table};
}

std::vector<ReferenceTable> analysis_reference() {
  auto tables = reference_of(measure_group());
  for (const auto& group : analysis_groups()) {
    for (const auto& table : group.reference) {
      const auto same = [&](const ReferenceTable& other) { return other.name == table.name; };
      if (const auto found = std::find_if(tables.begin(), tables.end(), same); found != tables.end()) {
        found->rows.insert(found->rows.end(), table.rows.begin(), table.rows.end());
      } else {
        tables.push_back(table);
      }
    }
  }
  return tables;
}

}  // namespace repose
