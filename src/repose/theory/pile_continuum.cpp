// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_continuum.hpp"

#include <cmath>
#include <numbers>

namespace repose::theory {

namespace {

double sine(double degrees) { return std::sin(degrees * (std::numbers::pi / 180.0)); }

/// x_c/B of (49): the lattice line from the apex against the flank meets the base there. 60 - slope is exact in
/// degrees.
double plateau_begins(double slope_deg) {
  return sine(60.0 - slope_deg) / (2.0 * sine(60.0) * std::cos(slope_deg * (std::numbers::pi / 180.0)));
}

}  // namespace

BaseForce base_force(const PileContinuum& model, double x_over_b) {
  const double slope = sine(model.slope_deg);
  const double x = x_over_b <= 0.5 ? x_over_b : 1.0 - x_over_b;  // from the nearer foot
  const double to_near_flank = slope / sine(120.0 - model.slope_deg);
  // Lengths of the diagonal with the near flank and of the one against it, which inside x_c ends on the far flank.
  // Their difference is written out, by sin(120 - a) - sin(60 - a) = sin(a), since it is far smaller than either on a
  // gentle slope.
  const double with_slope = x * to_near_flank;
  double against = (1.0 - x) * to_near_flank;
  double difference = (x - (1.0 - x)) * to_near_flank;
  if (x <= plateau_begins(model.slope_deg)) {
    against = x * slope / sine(60.0 - model.slope_deg);
    difference = -against * to_near_flank;
  }
  const double outward = difference / (2.0 * std::numbers::sqrt3) + 0.0;  // never minus zero
  return {0.5 * (with_slope + against), x_over_b <= 0.5 ? outward : 0.0 - outward};
}

void parameters(PileContinuum& model, Parameters& to) {
  to.number("slope_deg", model.slope_deg, {.low = 0.0, .high = 60.0, .low_allowed = false, .high_allowed = false},
            "deg", "slope of both flanks");
  to.integer("points", model.points, {.low = 2, .high = 10'000'000}, "places along the base, both feet included");
}

Table evaluate(const PileContinuum& model) {
  auto table = base_table(model.points, "chi g B", [&](double x_over_b) { return base_force(model, x_over_b); });
  const double tan_slope = std::tan(model.slope_deg * (std::numbers::pi / 180.0));
  table.numbers = {{"weight", tan_slope / (2.0 * std::numbers::sqrt3), "chi g B^2", "integral of normal over the base"},
                   {"x_c", plateau_begins(model.slope_deg), "B", "distance of the plateau from the foot"},
                   {"plateau_half_width", tan_slope / (2.0 * std::numbers::sqrt3), "B", "of the plateau, 1/2 - x_c"},
                   {"plateau_normal", base_force(model, 0.5).normal, "chi g B", "normal on the plateau, the largest"}};
  return table;
}

}  // namespace repose::theory
