// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/record.hpp"

#include "repose/analysis/wall_span.hpp"
#include "repose/methods/contacts.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace repose {

std::string status_text(Status status) {
  switch (status) {
    case Status::running:
      return "running";
    case Status::finished:
      return "finished";
    case Status::interrupted:
      return "interrupted";
    case Status::failed:
      return "failed";
  }
  return "";
}

Status status_of(const std::string& text) {
  for (const auto status : {Status::running, Status::finished, Status::interrupted, Status::failed}) {
    if (status_text(status) == text) return status;
  }
  throw std::out_of_range("no such status: " + text);
}

namespace {

double per_length(double force, const WallRow<2>& row) {
  return row.length > 0.0 ? force / row.length : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double pressure_of(const WallRow<2>& row, const Vec<2>& normal) { return per_length(-dot(row.force, normal), row); }
double shear_of(const WallRow<2>& row, const Vec<2>& normal) {
  return per_length(dot(row.force, along_wall(normal)), row);
}

template <int D>
std::vector<RecordedWall<D>> walls_at(const Record<D>& record, double time) {
  const auto walls = record.walls.size();
  std::vector<WallState> states(walls);
  const auto& rows = record.series;
  const auto next = static_cast<std::size_t>(
      std::lower_bound(rows.begin(), rows.end(), time, [](const auto& row, double t) { return row.time < t; }) -
      rows.begin());
  if (record.wall_series.size() != rows.size() * walls || rows.empty())
    return recorded_walls<D>(record.scene, {}, time);
  for (std::size_t w = 0; w < walls; ++w) {
    const auto displacement = [&](std::size_t row) { return record.wall_series[row * walls + w].displacement; };
    const double before = next > 0 ? displacement(next - 1) : 0.0;
    if (next == rows.size()) {
      states[w].displacement = before;
      continue;
    }
    const double start = next > 0 ? rows[next - 1].time : 0.0;
    const double passed = rows[next].time > start ? (time - start) / (rows[next].time - start) : 1.0;
    states[w].displacement = before + passed * (displacement(next) - before);
  }
  return recorded_walls<D>(record.scene, states, time);
}

template <int D>
ContactBlocks<D> contacts_of(const Record<D>& record) {
  if (record.supports.empty()) return blocks_of(record.contacts);
  return contacts_of_supports(*record.grains, record.supports, record.box);
}

CollisionAccount collision_account(const std::vector<SeriesRow>& series) {
  CollisionAccount all;
  for (const auto& row : series) all += row.collisions;
  return all;
}

SolverAccount solver_account(const std::vector<SeriesRow>& series) {
  SolverAccount all;
  for (const auto& row : series) all += row.solver;
  return all;
}

template std::vector<RecordedWall<2>> walls_at(const Record<2>&, double);
template std::vector<RecordedWall<3>> walls_at(const Record<3>&, double);
template ContactBlocks<2> contacts_of(const Record<2>&);
template ContactBlocks<3> contacts_of(const Record<3>&);

}  // namespace repose
