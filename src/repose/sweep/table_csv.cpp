// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/csv_cells.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>

namespace repose {

namespace {

/// Value of a parameter at a point, "" where the point does not set it.
std::string parameter_text(const SweepPoint& point, const std::string& key) {
  for (const auto& parameter : point.parameters) {
    if (parameter.key == key) return parameter.text;
  }
  return "";
}

}  // namespace

std::string table_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "point";
  for (const auto& key : plan.keys) text += fmt::format(",{}", csv_text(key));
  text += ",finished,failed";
  for (std::size_t m = 0; m < table.measures.size(); ++m) {
    text += fmt::format(",{0},{0}:error,{0}:deviation,{0}:count,{0}:missing,{0}:low,{0}:high", table.measures[m]);
    if (m >= table.own_measures()) text += fmt::format(",{}:bias", table.measures[m]);  // means have none
  }
  text += "\n";
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    text += csv_text(plan.points[p].name);
    for (const auto& key : plan.keys) text += fmt::format(",{}", csv_text(parameter_text(plan.points[p], key)));
    text += fmt::format(",{},{}", table.finished[p], table.failed[p]);
    for (std::size_t m = 0; m < table.measures.size(); ++m) {
      const auto& entry = table.entries[p][m];
      text += fmt::format(",{},{},{},{},{},{},{}", csv_number(entry.mean), csv_number(entry.error),
                          csv_number(entry.deviation), entry.count, entry.missing, csv_number(entry.low),
                          csv_number(entry.high));
      if (m >= table.own_measures()) text += fmt::format(",{}", csv_number(entry.bias));
    }
    text += "\n";
  }
  return text;
}

std::string members_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "point,seed,status";
  for (std::size_t m = 0; m < table.own_measures(); ++m) text += fmt::format(",{}", table.measures[m]);
  text += "\n";
  for (const auto& member : table.members) {
    text += fmt::format("{},{},{}", csv_text(plan.points[member.point].name), member.seed, member.status);
    for (const double value : member.values) text += fmt::format(",{}", csv_number(value));
    text += "\n";
  }
  return text;
}

}  // namespace repose
