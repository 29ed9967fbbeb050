// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/parameters.hpp"
#include "repose/core/vec.hpp"
#include "repose/methods/hybrid/spring.hpp"

#include <vector>

namespace repose {

struct HybridSettings {
  double time_step = unset;   ///< [T]
  Vec<2> gravity{};           ///< [L/T^2]
  double gravity_ramp = 0.0;  ///< [T] over which gravity rises from 0
  Box<2> box{};
  std::vector<Wall<2>> walls{};  ///< endless and at rest
  hybrid::Spring spring{};
  double slip_drag = 0.0;      ///< [M/T] K_slip, of the surfaces of soft contacts
  double static_friction = 0;  ///< mu_static of the wells at walls
  double well_width = unset;   ///< [L] a: a well breaks at this displacement
  double slow = unset;         ///< [L/T] hard contacts that separate slower turn soft; wells arm below it
  double weight = unset;       ///< [M L/T^2] unit of residuals
  double tolerance = 1e-7;     ///< [weight] largest residual of a grain
  bool by_sweeps = false;      ///< block Gauss-Seidel instead of the direct solver
  double relaxation = 0.8;     ///< of the sweeps
  bool pinned_base = false;    ///< grains that stand on a wall or on fixed grains at the start keep their x
  bool relaxed_start = false;  ///< the grains that touch at the start are brought to equilibrium
  double skin = unset;         ///< [L]
};

}  // namespace repose
