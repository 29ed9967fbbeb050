// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_continuum.hpp"

#include "repose/core/numbers.hpp"

#include <cmath>
#include <numbers>

namespace repose::theory {

namespace {

/// x_c/B of (49), where the lattice line down from the apex meets the base. 60 - slope is exact in degrees.
double plateau_begins(double slope_deg) {
  return std::sin(radians(60.0 - slope_deg)) /
         (2.0 * std::sin(radians(60.0)) * std::cos(slope_deg * (std::numbers::pi / 180.0)));
}

}  // namespace

BaseForce base_force(const PileContinuum& model, double x_over_b) {
  const double slope = std::sin(radians(model.slope_deg));
  const double x = x_over_b <= 0.5 ? x_over_b : 1.0 - x_over_b;  // from the nearer foot
  const double per_distance = slope / std::sin(radians(120.0 - model.slope_deg));
  // The length of the lattice line from x up towards the nearer side, which ends on the near flank, and of the one up
  // towards the farther side, which ends on the far flank on the plateau and on the near flank before it. On a gentle
  // slope their difference is far smaller than either, so it is computed separately, from
  // sin(120 - a) - sin(60 - a) = sin(a).
  const double near_line = x * per_distance;
  double far_line = (1.0 - x) * per_distance;
  double difference = (x - (1.0 - x)) * per_distance;
  if (x <= plateau_begins(model.slope_deg)) {
    far_line = x * slope / std::sin(radians(60.0 - model.slope_deg));
    difference = -far_line * per_distance;
  }
  const double outward = difference / (2.0 * std::numbers::sqrt3) + 0.0;  // + 0.0 avoids minus zero
  return {0.5 * (near_line + far_line), x_over_b <= 0.5 ? outward : 0.0 - outward};
}

void parameters(PileContinuum& model, Parameters& to) {
  to.number("slope_deg", model.slope_deg, {.low = 0.0, .high = 60.0, .low_allowed = false, .high_allowed = false},
            "deg", "slope of both flanks");
  to.integer("points", model.points, {.low = 2, .high = 1'000'000}, "positions along the base, both feet included");
}

Table evaluate(const PileContinuum& model) {
  auto table = base_table(model.points, "chi g B", [&](double x_over_b) { return base_force(model, x_over_b); });
  const double tan_slope = std::tan(model.slope_deg * (std::numbers::pi / 180.0));
  table.numbers = {{"weight", tan_slope / (2.0 * std::numbers::sqrt3), "chi g B^2", "integral of normal over the base"},
                   {"x_c", plateau_begins(model.slope_deg), "B", "distance of the plateau from the foot"},
                   {"plateau_half_width", tan_slope / (2.0 * std::numbers::sqrt3), "B", "half the plateau, 1/2 - x_c"},
                   {"plateau_normal", base_force(model, 0.5).normal, "chi g B", "normal on the plateau, its maximum"}};
  return table;
}

}  // namespace repose::theory
