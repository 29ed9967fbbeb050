// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// The account of the energy [M L^2/T^2]: what is there, and what has come and gone since the start.
struct Energy {
  double kinetic = 0.0;        ///< translation and rotation of the moving grains
  double gravitational = 0.0;  ///< of the moving grains, 0 at height 0
  double elastic = 0.0;        ///< of all contacts, with what springs of friction and rolling store
  double sources = 0.0;        ///< of the grains that were there at the start or added since
  double lost = 0.0;           ///< of the grains that have left
  double walls_work = 0.0;     ///< done by moving walls
  double loads_work = 0.0;     ///< done by outer forces on grains
  double damping = 0.0;        ///< dissipated by dashpots between grains
  double friction = 0.0;       ///< work of friction and rolling resistance between grains, less what is stored
  double walls = 0.0;          ///< dissipated at walls, by dashpot and friction, less what is stored

  double put_in() const { return sources + walls_work + loads_work; }
  double dissipated() const { return damping + friction + walls; }
  /// What is there less what should be: 0 but for the error of the integration.
  double error() const { return kinetic + gravitational + elastic + dissipated() + lost - put_in(); }
};

}  // namespace repose
