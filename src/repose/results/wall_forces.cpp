// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/wall_forces.hpp"

#include <cstddef>

namespace repose {

WallForces mean_wall_forces(const Record<2>& record) {
  constexpr double rounding = 1e-9;
  WallForces forces;
  const auto& rows = record.series;
  const auto count = record.walls.size();
  if (rows.empty() || count == 0 || record.wall_series.size() != rows.size() * count) return forces;
  forces.window_end = rows.back().time;
  const auto start_of = [&](std::size_t row) { return row > 0 ? rows[row - 1].time : 0.0; };
  std::size_t first = rows.size() - 1;
  const double from = forces.window_end - record.scene.output.window * (1.0 - rounding);
  while (first > 0 && start_of(first) > from) --first;
  forces.window_start = start_of(first);
  const double duration = forces.window_end - forces.window_start;
  const auto spans = spans_of(record.walls, *record.grains, record.box);
  for (std::size_t w = 0; w < count; ++w) {
    const auto& wall = record.walls[w];
    WallForce mean;
    mean.name = wall.name;
    mean.length = record.wall_series[(rows.size() - 1) * count + w].length;
    mean.middle = spans[w].middle;
    for (std::size_t row = first; row < rows.size(); ++row) {
      const auto& at = record.wall_series[row * count + w];
      const double part = (rows[row].time - start_of(row)) / duration;
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
