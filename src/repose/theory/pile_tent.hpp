// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/theory/base_force.hpp"
#include "repose/theory/model_text.hpp"
#include "repose/theory/table.hpp"

#include <cstdint>

namespace repose::theory {

/// The continuum pile with a break of slope in each flank. Lengths are those of the lattice directions at 60 degrees
/// inside the pile; no flank is as steep, so that each line from the base meets the surface once.
/// Source: Liffman et al. (1992), eqs (52), (53) and Fig. 18. Validated by tests/theory/pile_tent_test.cpp.
struct PileTent {
  double lower_slope_deg = 30.0;  ///< from the foot to the break, in (0, 60)
  double upper_slope_deg = 45.0;  ///< from the break to the apex, in (0, 60)
  double break_at = 0.38;         ///< from the nearer foot along the base, in B, in (0, 0.5]
  std::int64_t points = 201;      ///< along the base

  static constexpr ModelText text{.name = "pile-tent",
                                  .about =
                                      "Base forces of a close-packed pile with a break of slope, in the continuum "
                                      "limit",
                                  .source = "Liffman, Chan and Hughes 1992, eqs (52), (53), Figs. 18 and 19"};
};

/// Base force [chi g B] at x/B in [0, 1].
BaseForce base_force(const PileTent& model, double x_over_b);

void parameters(PileTent& model, Parameters& to);

/// Columns x_over_b, normal, shear (chi g B); numbers weight, centre_normal, peak_normal, dip (0 or 1) and dip_depth.
Table evaluate(const PileTent& model);

}  // namespace repose::theory
