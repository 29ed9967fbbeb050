// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/methods/method.hpp"
#include "repose/record/record.hpp"

#include <vector>

namespace repose {

class Simulation;

/// The time series of a run: one row after another, and of each row one of every wall.
class Series {
 public:
  /// Adds the row of the present state, with what the method has gathered since the row before.
  void add_row(const Simulation& simulation, Method<2>& method);

  const std::vector<SeriesRow>& rows() const { return rows_; }
  const std::vector<WallRow>& walls() const { return walls_; }

  void exchange(Archive& archive, std::size_t walls);

 private:
  void add_walls(const Simulation& simulation, const Contacts<2>& contacts, Method<2>& method);

  std::vector<SeriesRow> rows_;
  std::vector<WallRow> walls_;  // per row and wall
};

}  // namespace repose
