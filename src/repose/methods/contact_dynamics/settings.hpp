// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"

#include <limits>
#include <vector>

namespace repose {

/// Which contacts of a step start from their impulses of the step before; the others start from none.
enum class WarmStart {
  always,   ///< all that existed
  settled,  ///< those of grains that move slower than a tenth of g dt: impulses of an impact are not kept
  never
};

/// The settings of contact dynamics apart from the laws.
template <int D>
struct ContactDynamicsSettings {
  double time_step = 0.0;  ///< [T] > 0; g dt^2 / r of 0.05 to 0.15 for a heap
  Vec<D> gravity{};        ///< [L/T^2]
  Box<D> box{};
  std::vector<Wall<D>> walls;
  double speed_limit = std::numeric_limits<double>::infinity();  ///< [L/T] largest free speed, before contacts act
  contact_dynamics::SolverSettings solver{};
  WarmStart warm_start = WarmStart::always;
  double overlap_recovery = 0.05;  ///< fraction of an overlap that a step corrects, 0 to 1
  double skin = 0.3;               ///< [L] skin of the pair list
};

}  // namespace repose
