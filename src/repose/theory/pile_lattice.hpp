// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/base_force.hpp"
#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// A close-packed pile of equal hard discs with any slope up to 60 degrees: the lattice centres (x, y), in diameters,
/// with y <= tan(slope) min(x, base_count - 1 - x) + 1e-9. If a centre belongs to the pile, so do the two below it.
/// Contacts along rows carry no force, so each disc puts half its weight over cos(30) on each of the two lattice
/// diagonals that lead down from it.
/// Source: Liffman et al. (1992), eqs (37)-(44), here for any slope. Validated by tests/theory/pile_lattice_test.cpp.
struct PileLattice {
  double slope_deg = 30.0;       ///< slope of both flanks, in (0, 60]
  std::int64_t base_count = 45;  ///< discs in the base row

  static constexpr ModelText text{.name = "pile-lattice",
                                  .about = "Base forces of a close-packed triangular pile of equal hard discs",
                                  .source = "Liffman, Chan and Hughes 1992, eqs (37)-(44), for any slope"};
};

/// The number of discs on the lattice diagonal from base disc i (counted from 0, and included) up to the left.
std::int64_t discs_up_left(const PileLattice& model, std::int64_t i);

/// The force of base disc i (counted from 0) on the ground, in weights of a disc.
BaseForce base_force(const PileLattice& model, std::int64_t i);

void parameters(PileLattice& model, Parameters& to);

/// A table with the columns x_over_b (disc i of n at i/(n - 1)), normal and shear (m g), and the numbers discs and
/// weight.
Table evaluate(const PileLattice& model);

}  // namespace repose::theory
