// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bed.hpp"
#include "repose/methods/soft/kernels.hpp"

#include <cmath>

namespace repose::bench {

// The parameters of the bed (beds/README.md). For unit masses the damping gamma_n = 140 per reduced mass is a dashpot
// of 70 = 2 zeta sqrt(k). The tangential dashpot is half of it, the default of LAMMPS.
inline constexpr double stiffness = 5e4;
inline constexpr double tangential_stiffness = 2.0 / 7.0 * stiffness;
inline constexpr double time_step = 2e-4;

inline PairLaw<Hooke, Linear> hooke_linear() {
  return {Hooke{stiffness, 70.0 / (2.0 * std::sqrt(stiffness)), true},
          Linear{0.5, tangential_stiffness, 35.0 / (2.0 * std::sqrt(tangential_stiffness))}};
}

inline SoftSettings<2> settings_of(const Bed& bed) {
  SoftSettings<2> settings;
  settings.time_step = time_step;
  settings.gravity = {{0.0, -1.0}};
  settings.box = bed.box;
  settings.skin = 0.05;  // the fastest here; LAMMPS also runs with its best skin
  return settings;
}

}  // namespace repose::bench
