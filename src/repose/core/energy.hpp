// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// The energy budget [M L^2/T^2]: the energy present, and the energy supplied and removed since the start.
struct Energy {
  double kinetic = 0.0;        ///< translation and rotation of the moving grains
  double gravitational = 0.0;  ///< potential energy of the moving grains, 0 at height 0
  double elastic = 0.0;        ///< stored by all contacts, including the springs of friction and rolling
  double sources = 0.0;        ///< energy of the grains present at the start or added since
  double lost = 0.0;           ///< energy of the grains that have left
  double walls_work = 0.0;     ///< work done by moving walls
  double loads_work = 0.0;     ///< work done by external forces on grains
  double damping = 0.0;        ///< dissipated by dashpots between grains
  double friction = 0.0;       ///< work of friction and rolling resistance between grains, minus the stored part
  double walls = 0.0;          ///< dissipated at walls by dashpot and friction, minus the stored part
  double drag = 0.0;           ///< dissipated by global damping

  double put_in() const { return sources + walls_work + loads_work; }
  double dissipated() const { return damping + friction + walls + drag; }
  /// Energy present, dissipated and lost, minus the energy put in: 0 except for the integration error.
  double error() const { return kinetic + gravitational + elastic + dissipated() + lost - put_in(); }
};

}  // namespace repose
