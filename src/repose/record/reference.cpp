// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/reference.hpp"

#include "repose/io/state.hpp"
#include "repose/record/record_groups.hpp"
#include "repose/record/track_file.hpp"

namespace repose {

namespace {

template <class From>
ReferenceTable with_paths(const Group<From>& group) {
  return reference_of(group.name, "/" + group.name + "/", group.rows, group.columns);
}

ReferenceTable of_spheres(ReferenceTable table) {
  table.name += " of spheres";
  return table;
}

ReferenceTable track_table() {
  auto table = reference_of("track", "", "M", track_moment_columns<2>());
  const auto grains = reference_of("track", "", "rows", track_grain_columns<2>());
  table.rows.insert(table.rows.end(), grains.rows.begin(), grains.rows.end());
  return table;
}

}  // namespace

std::vector<ReferenceTable> run_folder_reference() {
  return {
      reference_of("run.h5", run_attributes<2>()),
      reference_of("grains", "/grains/", "N", grain_state_columns<2>()),
      reference_of("contacts", "/contacts/", "M", contact_columns<2>()),
      with_paths(wall_group<2>()),
      with_paths(series_group()),
      reference_of("series of walls", "/series/", "R", wall_series_columns<2>()),
      with_paths(column_group<2>()),
      of_spheres(with_paths(column_group<3>())),
      with_paths(energy_group()),
      with_paths(solver_group()),
      with_paths(collision_group()),
      reference_of("base", base_group<2>().attributes),
      with_paths(base_group<2>()),
      track_table(),
  };
}

}  // namespace repose
