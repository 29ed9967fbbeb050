// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/series_arrays.hpp"

#include "repose/view/arrays.hpp"

namespace repose {

namespace {

/// One number of every row.
template <class Rows, class Get>
std::vector<float> each(const Rows& rows, Get get) {
  std::vector<float> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(static_cast<float>(get(row)));
  return values;
}

void add_walls(ArrayMessage& message, const Record<2>& run) {
  const auto walls = run.walls.size();
  for (std::size_t w = 0; w < walls && !run.wall_series.empty(); ++w) {
    const auto column = [&](const char* name, auto get) {
      std::vector<float> values;
      for (std::size_t k = w; k < run.wall_series.size(); k += walls) {
        values.push_back(static_cast<float>(get(run.wall_series[k])));
      }
      message.add(std::string(name) + ":" + run.walls[w].name, values);
    };
    column("wall_force_x", [](const WallRow<2>& row) { return row.force[0]; });
    column("wall_force_y", [](const WallRow<2>& row) { return row.force[1]; });
    if (run.walls[w].wall.motion.kind != WallMotion<2>::Kind::none)
      column("wall_displacement", [](const WallRow<2>& row) { return row.displacement; });
  }
}

}  // namespace

std::string series_arrays(const Record<2>& run) {
  ArrayMessage message(nlohmann::ordered_json::object());
  const auto& rows = run.series;
  message.add("time", each(rows, [](const auto& row) { return row.time; }));
  message.add("kinetic_energy_per_grain", each(rows, [](const auto& row) { return row.kinetic_energy_per_grain; }));
  message.add("force_residual", each(rows, [](const auto& row) { return row.force_residual; }));
  message.add("max_overlap", each(rows, [](const auto& row) { return row.max_overlap; }));
  message.add("grains", each(rows, [](const auto& row) { return row.grains; }));
  message.add("contacts", each(rows, [](const auto& row) { return row.contacts; }));
  message.add("lost", each(rows, [](const auto& row) { return row.lost; }));
  add_walls(message, run);
  return message.bytes();
}

}  // namespace repose
