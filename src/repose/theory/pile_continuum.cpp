// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_continuum.hpp"

#include <cmath>
#include <numbers>

namespace repose::theory {

BaseForce base_force(const PileContinuum& model, double x_over_b) {
  constexpr double third = std::numbers::pi / 3.0;
  const double slope = model.slope_deg * (std::numbers::pi / 180.0);
  const double x = x_over_b <= 0.5 ? x_over_b : 1.0 - x_over_b;  // from the nearer foot
  const double with_slope = x * std::sin(slope) / std::sin(2.0 * third - slope);
  const double x_centre = 0.5 * (1.0 - std::tan(slope) / std::numbers::sqrt3);  // (49)
  // Length of the diagonal that leans against the near flank; inside x_centre it ends on the far one.
  const double against = x <= x_centre ? x * std::sin(slope) / std::sin(third - slope)
                                       : (1.0 - x) * std::sin(slope) / std::sin(2.0 * third - slope);
  const double outward = (with_slope - against) / (2.0 * std::numbers::sqrt3);
  return {0.5 * (with_slope + against), x_over_b <= 0.5 ? outward : 0.0 - outward};
}

void parameters(PileContinuum& model, ModelParameters& to) {
  to.number("slope_deg", model.slope_deg, {.low = 0.0, .high = 60.0, .low_allowed = false, .high_allowed = false},
            "deg", "slope of both flanks");
  to.integer("points", model.points, {.low = 2, .high = 10'000'000}, "places along the base, both feet included");
}

Table evaluate(const PileContinuum& model) {
  return base_table(model.points, "chi g B", [&](double x_over_b) { return base_force(model, x_over_b); });
}

}  // namespace repose::theory
