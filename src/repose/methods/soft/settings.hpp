// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <vector>

namespace repose {

/// Damping of every moving grain, besides that of its contacts.
struct GlobalDamping {
  /// Cundall's: each component of the net force and torque is weaker by this fraction where it speeds the grain up, and
  /// stronger where it slows it down; >= 0, < 1. Source: Cundall (1987).
  double local = 0.0;
  double viscous = 0.0;  ///< [1/T] a force of minus this times mass and velocity, and a torque alike; >= 0

  bool any() const { return local > 0.0 || viscous > 0.0; }
};

/// The settings of the soft method apart from the laws.
template <int D>
struct SoftSettings {
  double time_step = 0.0;  ///< [T] > 0
  Vec<D> gravity{};        ///< [L/T^2]
  Box<D> box{};
  std::vector<Wall<D>> walls;
  bool synchronised = false;       ///< compute forces from velocities predicted for the full step (large size ratios)
  bool audit = false;              ///< keep the energy budget; in a full kernel only
  bool reference = false;          ///< use the general kernel even if a fused one gives the same bits faster
  double skin = 0.3;               ///< [L] skin of the pair list
  double smallest_diameter = 1.0;  ///< [L] of any grain, from which the longest bond follows
  GlobalDamping damping{};         ///< in a full kernel only
};

}  // namespace repose
