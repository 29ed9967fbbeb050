// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/wall_forces.hpp"

#include <cstddef>

namespace repose {

WindowRows rows_of_window(const std::vector<SeriesRow>& rows, double window) {
  constexpr double rounding = 1e-9;
  WindowRows found;
  if (rows.empty()) return found;
  found.end = rows.back().time;
  const auto start_of = [&](std::size_t row) { return row > 0 ? rows[row - 1].time : 0.0; };
  found.first = rows.size() - 1;
  const double from = found.end - window * (1.0 - rounding);
  while (found.first > 0 && start_of(found.first) > from) --found.first;
  found.start = start_of(found.first);
  const double duration = found.end - found.start;
  for (auto row = found.first; row < rows.size(); ++row) {
    found.parts.push_back((rows[row].time - start_of(row)) / duration);
  }
  return found;
}

WallForces mean_wall_forces(const Record<2>& record) {
  WallForces forces;
  const auto& rows = record.series;
  const auto count = record.walls.size();
  if (rows.empty() || count == 0 || record.wall_series.size() != rows.size() * count) return forces;
  const auto window = rows_of_window(rows, record.scene.output.window);
  forces.window_start = window.start;
  forces.window_end = window.end;
  const auto spans = spans_of(record.walls, *record.grains, record.box);
  for (std::size_t w = 0; w < count; ++w) {
    const auto& wall = record.walls[w];
    WallForce mean;
    mean.name = wall.name;
    mean.length = record.wall_series[(rows.size() - 1) * count + w].length;
    mean.middle = spans[w].middle;
    for (auto row = window.first; row < rows.size(); ++row) {
      const auto& at = record.wall_series[row * count + w];
      const double part = window.parts[row - window.first];
      mean.force += at.force * part;
      mean.pressure += part * pressure_of(at, wall.wall.normal);
      mean.shear += part * shear_of(at, wall.wall.normal);
      mean.moment += part * at.moment;
    }
    forces.walls.push_back(std::move(mean));
  }
  return forces;
}

}  // namespace repose
