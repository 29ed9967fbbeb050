// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/base_profile.hpp"
#include "repose/analysis/pipe.hpp"
#include "repose/core/collision_account.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/energy.hpp"
#include "repose/core/ordered_grains.hpp"
#include "repose/core/solver_account.hpp"
#include "repose/core/track.hpp"
#include "repose/record/recorded_wall.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

/// A wall at one row of the time series.
template <int D>
struct WallRow {
  double displacement = 0.0;  ///< [L] along the direction in which it moves
  Vec<D> force{};             ///< [M L/T^2] of the grains on it, mean since the row before
  // In two dimensions alone.
  double length = 0.0;  ///< [L] of the part that grains can press on (analysis/wall_span.hpp)
  double moment = 0.0;  ///< [M L^2/T^2] of the contacts at that time about the middle of it, counter-clockwise
};

/// The force per length [M/T^2] of the grains on a wall with this normal: against the normal, so that pressure is
/// positive, and along the normal turned by +90 degrees. NaN for a wall without length.
double pressure_of(const WallRow<2>& row, const Vec<2>& normal);
double shear_of(const WallRow<2>& row, const Vec<2>& normal);

/// One row of the time series.
struct SeriesRow {
  double time = 0.0;                      ///< [T]
  std::int64_t grains = 0;                ///< moving grains present
  std::int64_t lost = 0;                  ///< grains that have left
  std::int64_t contacts = 0;              ///< above the force threshold of the analysis
  double kinetic_energy_per_grain = 0.0;  ///< [M L^2/T^2]
  double force_residual = 0.0;            ///< see analysis/force_network.hpp
  double max_overlap = 0.0;               ///< over the mean diameter of the pair
  Energy energy{};                        ///< all 0 unless the scene asks for the account
  SolverAccount solver{};                 ///< since the row before, of contact dynamics
  CollisionAccount collisions{};          ///< since the row before, of the hybrid method
  double creep_rate = 0.0;                ///< [L/T] median speed of grains that touch something, of contact dynamics
};

enum class Status { running, finished, interrupted, failed };
std::string status_text(Status status);
/// Throws std::out_of_range for an unknown word.
Status status_of(const std::string& text);

/// How a run went.
struct RunFacts {
  Status status = Status::running;
  std::string message;  ///< why it stopped
  double time = 0.0;    ///< [T]
  double time_step = 0.0;
  std::int64_t steps = 0;
  std::int64_t threads = 1;
  double wall_seconds = 0.0;
  double grain_steps = 0.0;  ///< moving grains times steps
  std::int64_t released = 0;
  std::int64_t lost = 0;
  std::string state_hash;      ///< of the exact state, see io/state.hpp
  std::string scene_hash;      ///< of the text of the scene that is run: the same in every file of a run
  double support_force = 0.0;  ///< [M L/T^2] downward force on fixed grains (mean over the window) and walls (now)
};

/// What a run leaves behind: all that the analysis knows of it, in memory or read back from a run folder.
template <int D = 2>
struct Record {
  Scene scene;
  RunFacts facts;
  Box<D> box;
  std::vector<RecordedWall<D>> walls;  ///< as they stand, by number
  OrderedGrains<D> grains;
  Contacts<D> contacts;               ///< empty where they follow from `supports`
  std::vector<SupportPair> supports;  ///< for each grain what it came to rest on, by places in `grains`; or empty
  std::vector<SeriesRow> series;
  std::vector<WallRow<D>> wall_series;     ///< for each row of the series, a row for each wall
  std::vector<ColumnRow> column_series;    ///< for each row of the series; empty where the scene has no pipe
  std::vector<ColumnSlice> column_slices;  ///< for each of these, output.slices from the floor up
  BaseProfile base;
  Track<D> track;
};

/// The walls as they stood at a time [T]: where the rows of the series have them, and between these on a straight line.
template <int D>
std::vector<RecordedWall<D>> walls_at(const Record<D>& record, double time);

/// All contacts of a record, which must outlive them.
template <int D>
ContactBlocks<D> contacts_of(const Record<D>& record);

/// What the solver did from the start to the last row of the series.
SolverAccount solver_account(const std::vector<SeriesRow>& series);

/// What collided and turned soft from the start to the last row of the series.
CollisionAccount collision_account(const std::vector<SeriesRow>& series);

}  // namespace repose
