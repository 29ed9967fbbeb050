// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_number(double x) { return std::isnan(x) ? "" : fmt::format("{}", x); }

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
  for (const auto& name : table.measures) text += fmt::format(",{0},{0}:error,{0}:deviation,{0}:count", name);
  text += "\n";
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    text += csv_text(plan.points[p].name);
    for (const auto& key : plan.keys) text += fmt::format(",{}", csv_text(parameter_text(plan.points[p], key)));
    text += fmt::format(",{},{}", table.finished[p], table.failed[p]);
    for (const auto& entry : table.entries[p]) {
      text += fmt::format(",{},{},{},{}", csv_number(entry.mean), csv_number(entry.error), csv_number(entry.deviation),
                          entry.count);
    }
    text += "\n";
  }
  return text;
}

std::string members_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "point,seed,status";
  const auto own_measures = table.measures.size() - 2;  // the last two are of profiles
  for (std::size_t m = 0; m < own_measures; ++m) text += fmt::format(",{}", table.measures[m]);
  text += "\n";
  for (const auto& member : table.members) {
    text += fmt::format("{},{},{}", csv_text(plan.points[member.point].name), member.seed, member.status);
    for (const double value : member.values) text += fmt::format(",{}", csv_number(value));
    text += "\n";
  }
  return text;
}

std::string claims_csv(const SweepPlan& plan, const SweepTable& table) {
  std::string text = "claim,source,measure,kind,points,above,below,value,error,verdict\n";
  for (std::size_t k = 0; k < plan.claims.size(); ++k) {
    const auto& claim = plan.claims[k];
    const auto& verdict = table.verdicts[k];
    std::string points;
    for (const auto& name : claim.points) points += (points.empty() ? "" : " ") + name;
    const auto* kind = claim.kind == Claim::Kind::value        ? "value"
                       : claim.kind == Claim::Kind::difference ? "difference"
                                                               : "spread";
    const auto bound = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : std::string(); };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_text(claim.text), csv_text(claim.source), claim.measure,
                        kind, csv_text(points), bound(claim.above), bound(claim.below), csv_number(verdict.value),
                        csv_number(verdict.error), verdict.word);
  }
  return text;
}

}  // namespace repose
