// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/point_inference.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace repose {

namespace {

using Rows = std::vector<const MemberRow*>;

bool of_profile(const SweepTable& table, std::size_t measure) { return measure >= table.own_measures(); }

/// The finished members of a point that have a measure.
Rows rows_with(const SweepTable& table, std::size_t measure, std::size_t point) {
  Rows rows;
  if (of_profile(table, measure) && !table.profiles[point]) return rows;
  for (const auto& member : table.members) {
    if (member.point != point || member.status != "finished") continue;
    if (!of_profile(table, measure) && std::isnan(member.values[measure])) continue;
    rows.push_back(&member);
  }
  return rows;
}

/// The members of both points with the same seeds, in one order.
std::pair<Rows, Rows> pairs_of(const Rows& first, const Rows& second) {
  std::pair<Rows, Rows> pairs;
  for (const auto* a : first) {
    for (const auto* b : second) {
      if (a->seed != b->seed) continue;
      pairs.first.push_back(a);
      pairs.second.push_back(b);
    }
  }
  return pairs;
}

std::vector<double> values_of(const Rows& rows, std::size_t measure) {
  std::vector<double> values;
  for (const auto* row : rows) values.push_back(row->values[measure]);
  return values;
}

std::vector<const BaseProfile*> bases_of(const Rows& rows) {
  std::vector<const BaseProfile*> bases;
  for (const auto* row : rows) bases.push_back(&row->base);
  return bases;
}

const ProfileMeasure& profile_measure(const SweepTable& table, std::size_t measure) {
  return profile_measures()[measure - table.own_measures()];
}

}  // namespace

Inference infer(const SweepTable& table, std::size_t measure, std::size_t point) {
  const auto rows = rows_with(table, measure, point);
  if (!of_profile(table, measure)) return mean_by_t(values_of(rows, measure));
  if (rows.empty()) return {};
  return inferred(profile_measure(table, measure), bases_of(rows));
}

Inference infer_difference(const SweepTable& table, std::size_t measure, std::size_t first, std::size_t second) {
  const auto first_rows = rows_with(table, measure, first);
  const auto second_rows = rows_with(table, measure, second);
  const auto pairs = pairs_of(first_rows, second_rows);
  const bool paired = pairs.first.size() >= 2;
  const auto& a = paired ? pairs.first : first_rows;
  const auto& b = paired ? pairs.second : second_rows;
  if (of_profile(table, measure)) {
    if (a.empty() || b.empty()) return {};
    return inferred_difference(profile_measure(table, measure), bases_of(a), bases_of(b), paired);
  }
  if (paired) return paired_difference(values_of(a, measure), values_of(b, measure));
  return welch_difference(values_of(a, measure), values_of(b, measure));
}

}  // namespace repose
