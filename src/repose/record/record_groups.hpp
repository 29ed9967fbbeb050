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
template <int D>
const Attributes<Record<D>>& run_attributes();
template <>
const Attributes<Record<2>>& run_attributes();
template <>
const Attributes<Record<3>>& run_attributes();

template <int D>
const Group<std::vector<RecordedWall<D>>>& wall_group();
template <>
const Group<std::vector<RecordedWall<2>>>& wall_group();
template <>
const Group<std::vector<RecordedWall<3>>>& wall_group();

/// The time series; `wall_series_columns` belong to the same group, where there are walls.
const Group<std::vector<SeriesRow>>& series_group();
template <int D>
const Columns<Record<D>>& wall_series_columns();
template <>
const Columns<Record<2>>& wall_series_columns();
template <>
const Columns<Record<3>>& wall_series_columns();

/// The column in a pipe, row by row of the time series.
template <int D>
const Group<Record<D>>& column_group();
template <>
const Group<Record<2>>& column_group();
template <>
const Group<Record<3>>& column_group();

/// The energy budget, what the solver did and what collided, row by row of the time series.
const Group<std::vector<SeriesRow>>& energy_group();
const Group<std::vector<SeriesRow>>& solver_group();
const Group<std::vector<SeriesRow>>& collision_group();

template <int D>
const Group<BaseProfile>& base_group();
template <>
const Group<BaseProfile>& base_group<2>();
template <>
const Group<BaseProfile>& base_group<3>();

}  // namespace repose
