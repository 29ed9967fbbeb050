// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/hybrid/step.hpp"

#include <vector>

namespace repose::hybrid {

enum class Relaxed {
  done,       ///< the residual of every grain is below the tolerance
  moved_far,  ///< grains have moved so far that the list of near grains must be built again
  failed
};

/// How a relaxation goes.
struct Relaxation {
  double length = 0.0;  ///< [T] of the next step of descent
  long steps = 0;       ///< so far
  double growth = 4.0;  ///< of the length, from step to step
  double left = 1.0;    ///< [weight] largest net force so far
  std::uint32_t worst = nobody;
  double load = 0.0;                ///< fraction of gravity that acts; 0: not yet decided
  std::vector<Vec<2>> displaced{};  ///< [L] of each grain, from the start
};

/// Brings the grains with soft contacts to equilibrium, without time and velocities: implicit steps of descent in
/// energy, each longer than the one before, whose end is Newton's method on the statics. Gravity rises by stages:
/// springs that touch at the start yield in proportion to it, as long as contacts turn little, so that each stage
/// begins near its end. Static wells hold, and break where they would be left. Validated by
/// tests/unit/hybrid_statics_test.cpp.
Relaxed relax(const Surroundings& around, Grains<2>& grains, Touches& touches, SoftSystem& system, DirectSolver& solver,
              Relaxation& progress, CollisionAccount& account);

}  // namespace repose::hybrid
