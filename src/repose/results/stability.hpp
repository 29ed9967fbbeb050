// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace repose {

/// How far a grain moves in a mode.
struct GrainMode {
  std::int64_t id = 0;
  Vec<2> displacement{};  ///< over the largest of all grains
};

/// Whether a pile at rest is stable against small displacements: the smallest eigenvalue of its stiffness matrix. See
/// docs/physics/stability.md.
struct Stability {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string problem;          ///< why there is no matrix; empty where there is one
  std::int64_t grains = 0;      ///< moving grains with a contact that carries force
  std::int64_t contacts = 0;    ///< contacts that carry force on these
  std::int64_t directions = 0;  ///< in which these grains can move: the size of the matrix
  double unbalanced = none;     ///< [grain weights] largest net force on a grain
  double stiffness = none;      ///< [grain weights / d] mean of the contacts
  double smallest = none;       ///< [grain weights / d] eigenvalue; below 0: unstable
  double relative = none;       ///< the same over the mean stiffness
  std::int64_t negative = 0;    ///< eigenvalues below -1e-9 of the mean stiffness
  std::int64_t neutral = 0;     ///< eigenvalues within that of 0
  double residual = none;       ///< |K u - lambda u| / |u| over the mean stiffness
  double participation = none;  ///< (sum of u^2)^2 / sum of u^4 over the grains: how many take part
  std::vector<GrainMode> mode;  ///< of that eigenvalue, by ascending id
};

}  // namespace repose
