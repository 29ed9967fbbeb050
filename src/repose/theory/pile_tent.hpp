// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/base_force.hpp"
#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// The continuum pile with a break of slope in each flank. The force on the base follows from the lengths inside the
/// pile of the lattice lines at 60 degrees. Every flank is less steep, so each line meets the surface once.
/// Source: Liffman et al. (1992), eqs (52), (53) and Fig. 18. Validated by tests/theory/pile_tent_test.cpp.
struct PileTent {
  double lower_slope_deg = 30.0;  ///< from the foot to the break, in (0, 60)
  double upper_slope_deg = 45.0;  ///< from the break to the apex, in (0, 60)
  double break_at = 0.38;         ///< distance of the break from the nearer foot along the base, in B, in (0, 0.5]
  std::int64_t points = 201;      ///< positions along the base

  static constexpr ModelText text{.name = "pile-tent",
                                  .about =
                                      "Base forces of a close-packed pile with a break of slope, in the continuum "
                                      "limit",
                                  .source = "Liffman, Chan and Hughes 1992, eqs (52), (53), Figs. 18 and 19"};
};

/// Base force [chi g B] at x/B in [0, 1].
BaseForce base_force(const PileTent& model, double x_over_b);

void parameters(PileTent& model, Parameters& to);

/// A table with the columns x_over_b, normal and shear (chi g B), and the numbers weight, centre_normal, peak_normal,
/// dip (0 or 1) and dip_depth.
Table evaluate(const PileTent& model);

}  // namespace repose::theory
