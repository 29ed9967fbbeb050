// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/vec.hpp"

#include <vector>

namespace repose {

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
};

}  // namespace repose
