// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/tail_fit.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace repose {

/// What drives a wall at one time, and how far it has come.
struct DriveRow {
  double time = 0.0;                                                 ///< [T]
  double force = 0.0;                                                ///< [M L/T^2] that drives it
  double displacement = 0.0;                                         ///< [L]
  double solid_fraction = std::numeric_limits<double>::quiet_NaN();  ///< of the column; NaN without a pipe
};

/// A fall of the force on a driven wall, from a local maximum to the next minimum.
struct Slip {
  double begin = 0.0;       ///< [T]
  double end = 0.0;         ///< [T]
  double force = 0.0;       ///< [M L/T^2] at the beginning
  double drop = 0.0;        ///< [M L/T^2] by which it falls
  double slide = 0.0;       ///< [L] of the wall during the slip
  double waiting = 0.0;     ///< [T] since the end of the slip before; NaN for the first
  double creep = 0.0;       ///< [L] of the wall since then; NaN for the first
  double dilation = 0.0;    ///< by which the volume of the column grows in the slip, over itself; NaN without a pipe
  double compaction = 0.0;  ///< by which it has shrunk since the slip before; NaN for the first
};

/// Stick and slip of a driven wall. See docs/physics/slips.md.
struct Slips {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string problem;          ///< why there are none to look for; empty where there are
  std::string wall;             ///< the driven wall
  double from = none;           ///< [T] slips before then are left out
  double mean_force = none;     ///< [M L/T^2] from then on
  double hysteresis = none;     ///< [M L/T^2] smaller changes of the force are no slips
  double sliding = none;        ///< fraction of that time spent in slips
  double stuck = none;          ///< fraction of that time in which the wall is slower than a tenth of its drive
  double deviation = none;      ///< standard deviation of the force over its mean
  double drive_speed = none;    ///< [L/T] of the far end of the spring, or of the wall
  double steady_speed = none;   ///< [L/T] v_t = (m/k)^(1/2) g, m the mass of piston and grains; NaN without a spring
  std::vector<DriveRow> drive;  ///< by time, from then on
  std::vector<Slip> events;
  TailFit drops;
};

}  // namespace repose
