// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/base_force.hpp"
#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// A close-packed pile of infinitely small discs, whose weight is carried along the two lattice directions at 60
/// degrees. Source: Liffman et al. (1992), eqs (49)-(59). Validated by tests/theory/pile_continuum_test.cpp.
struct PileContinuum {
  double slope_deg = 30.0;    ///< slope of both flanks, in (0, 60)
  std::int64_t points = 201;  ///< positions along the base

  static constexpr ModelText text{.name = "pile-continuum",
                                  .about = "Base forces of a close-packed triangular pile in the continuum limit",
                                  .source = "Liffman, Chan and Hughes 1992, eqs (49)-(59)"};
};

/// Base force [chi g B] at x/B in [0, 1].
BaseForce base_force(const PileContinuum& model, double x_over_b);

void parameters(PileContinuum& model, Parameters& to);

/// A table with the columns x_over_b, normal and shear (chi g B), and the numbers weight, x_c, plateau_half_width and
/// plateau_normal.
Table evaluate(const PileContinuum& model);

}  // namespace repose::theory
