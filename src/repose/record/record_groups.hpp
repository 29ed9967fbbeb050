// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/groups.hpp"
#include "repose/record/record.hpp"

#include <cstdint>
#include <vector>

namespace repose {

inline constexpr auto run_format = "repose-run";
inline constexpr std::int64_t run_format_version = 4;

// What run.h5 holds beside the groups of io/state.hpp: lists that write it, read it and print its reference.

/// The attributes of the file.
const Attributes<Record>& run_attributes();

const Group<std::vector<RecordedWall>>& wall_group();

/// The time series; `wall_series_columns` belong to the same group, where there are walls.
const Group<std::vector<SeriesRow>>& series_group();
const Columns<Record>& wall_series_columns();

/// The column in a pipe, row by row of the time series.
const Group<Record>& column_group();

/// The energy budget, what the solver did and what collided, row by row of the time series.
const Group<std::vector<SeriesRow>>& energy_group();
const Group<std::vector<SeriesRow>>& solver_group();
const Group<std::vector<SeriesRow>>& collision_group();

const Group<BaseProfile>& base_group();

}  // namespace repose
