// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace repose {

/// A contact that carries force, as a spring between two grains, or a grain and what does not move.
struct ContactSpring {
  static constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();

  std::size_t first = 0;         ///< a moving grain
  std::size_t second = nothing;  ///< another; `nothing`: a fixed grain or a wall
  Vec<2> normal{};
  double stiffness = 0.0;  ///< [M/T^2] -d(force)/d(distance)
  double force = 0.0;      ///< [M L/T^2] normal force
  /// [L] between the centres; infinite for a flat wall, along which the normal does not turn.
  double distance = std::numeric_limits<double>::infinity();
  bool holds = false;  ///< the partner does not let the first grain move along the tangent
};

/// A symmetric matrix by the entries of its lower triangle; entries of one place add up.
struct SymmetricMatrix {
  struct Entry {
    std::size_t row = 0;
    std::size_t column = 0;  ///< <= row
    double value = 0.0;
  };
  std::size_t size = 0;
  std::vector<Entry> lower;
};

/// The stiffness matrix of grains and the directions in which they can move.
struct StiffnessMatrix {
  /// Unit vectors, and the number of the first of them among all unknowns.
  struct Freedom {
    std::vector<Vec<2>> directions;
    std::size_t first = 0;
  };
  SymmetricMatrix matrix;        ///< [M/T^2]
  std::vector<Freedom> freedom;  ///< of each grain; one without a spring has none
};

/// The second derivatives of the energy of the springs and of constant forces: k n n - (F/r) t t of each contact, with
/// its stiffness k, force F and distance r. Grains have no friction, so that their rotations have no part in it.
/// Derived in docs/physics/stability.md. Validated by tests/unit/stability_test.cpp.
StiffnessMatrix stiffness_matrix(std::size_t grains, const std::vector<ContactSpring>& springs);

}  // namespace repose
