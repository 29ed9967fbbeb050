// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/methods/method.hpp"
#include "repose/record/record.hpp"

#include <vector>

namespace repose {

template <int D>
class Simulation;

/// In how many slices the series follows the column of a scene; 0 where it has no pipe.
std::size_t followed_slices(const Scene& scene);

/// The time series of a run: one row after another, and of each row one of every wall.
template <int D>
class Series {
 public:
  /// Adds the row of the present state, with what the method has gathered since the row before.
  void add_row(const Simulation<D>& simulation, Method<D>& method);

  const std::vector<SeriesRow>& rows() const { return rows_; }
  const std::vector<WallRow<D>>& walls() const { return walls_; }
  const std::vector<ColumnRow>& columns() const { return columns_; }
  const std::vector<ColumnSlice>& slices() const { return slices_; }

  /// `slices`: of the column; 0 where the scene has no pipe.
  void exchange(Archive& archive, std::size_t walls, std::size_t slices);

 private:
  void add_walls(const Simulation<D>& simulation, const Contacts<D>& contacts, Method<D>& method);
  void add_spans(const Simulation<D>& simulation, const Contacts<D>& contacts, const Method<D>& method);
  void add_column(const Simulation<D>& simulation, const Contacts<D>& contacts, const Method<D>& method);

  std::vector<SeriesRow> rows_;
  std::vector<WallRow<D>> walls_;  // per row and wall
  std::vector<ColumnRow> columns_;
  std::vector<ColumnSlice> slices_;  // per row and slice
};

}  // namespace repose
