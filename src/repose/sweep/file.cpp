// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/bootstrap.hpp"
#include "repose/core/version.hpp"
#include "repose/results/registry.hpp"
#include "repose/sweep/groups.hpp"
#include "repose/sweep/table.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>

namespace repose {

namespace {

void write_points(Hdf5File& file, const SweepPlan& plan, const SweepTable& table) {
  std::vector<PointRow> rows;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    rows.push_back({plan.points[p].name, table.finished[p], table.failed[p]});
  }
  write_group(file, point_group(), rows);
}

/// Parameters that differ between points, as numbers and as text.
void write_parameters(Hdf5File& file, const SweepPlan& plan) {
  file.group("parameters");
  file.group("parameter_text");
  for (const auto& key : plan.keys) {
    std::vector<double> numbers(plan.points.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::string> texts(plan.points.size());
    for (std::size_t p = 0; p < plan.points.size(); ++p) {
      for (const auto& parameter : plan.points[p].parameters) {
        if (parameter.key != key) continue;
        numbers[p] = parameter.number;
        texts[p] = parameter.text;
      }
    }
    if (std::set<std::string>(texts.begin(), texts.end()).size() < 2) continue;
    file.dataset("parameters/" + key, numbers, 1, "", "by point; not a number where the value is none");
    file.texts("parameter_text/" + key, texts, "by point, as TOML");
  }
}

std::string unit_of(const std::string& measure) {
  const auto* known = find_measure(measure);
  return known != nullptr ? known->unit : "";
}

void write_measures(Hdf5File& file, const SweepTable& table) {
  file.group("measures");
  for (std::size_t m = 0; m < table.measures.size(); ++m) {
    std::vector<EnsembleEstimate> points;
    for (const auto& entries : table.entries) points.push_back(entries[m]);
    write_group(file, estimate_group("measures/" + table.measures[m], unit_of(table.measures[m])), points);
  }
}

void write_members(Hdf5File& file, const SweepTable& table) {
  write_group(file, member_group(), table.members);
  file.group("values");
  for (std::size_t m = 0; m < table.own_measures(); ++m) {
    std::vector<double> values;
    for (const auto& member : table.members) values.push_back(member.values[m]);
    file.dataset("values/" + table.measures[m], values, 1, unit_of(table.measures[m]), "by member");
  }
}

}  // namespace

void write_sweep_file(const std::string& path, const SweepPlan& plan, const SweepTable& table) {
  Hdf5File file(path, plan.points.front().scene.units);
  file.attribute("/", "format", std::string("repose-sweep"));
  file.attribute("/", "format_version", std::int64_t{1});
  file.attribute("/", "repose_version", std::string(version));
  file.attribute("/", "title", plan.title);
  file.attribute("/", "units", plan.points.front().scene.units);
  const auto dimension = plan.points.front().scene.dimension;
  if (dimension == 3) file.attribute("/", "dimension", dimension);  // files without it are of discs
  file.attribute("/", "interval", interval_probability);
  file.attribute("/", "resamples", static_cast<std::int64_t>(resamples));
  write_points(file, plan, table);
  write_parameters(file, plan);
  write_measures(file, table);
  write_members(file, table);
  file.group("profiles");
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (!table.profiles[p]) continue;
    const auto group = fmt::format("profiles/{:04}", p);
    write_group(file, profile_group(group), *table.profiles[p]);
    write_group(file, binned_group(group + "/binned"), table.profiles[p]->binned);
  }
  file.group("columns");
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    if (!table.columns[p]) continue;
    const auto group = column_group(fmt::format("columns/{:04}", p), plan.points[p].scene.dimension);
    write_group(file, group, *table.columns[p]);
  }
  file.commit();
}

}  // namespace repose
