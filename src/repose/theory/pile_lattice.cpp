// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace repose::theory {

namespace {

constexpr double half_sqrt3 = 0.5 * std::numbers::sqrt3;

/// Centres on the surface belong to the pile, independently of rounding.
constexpr double surface_tolerance = 1e-9;

/// Whether the disc `up` rows above base disc i, on the diagonal to the left, is in the pile.
bool is_kept(double tan_slope, std::int64_t base_count, std::int64_t i, std::int64_t up) {
  const double x = static_cast<double>(i) - 0.5 * static_cast<double>(up);
  const double y = half_sqrt3 * static_cast<double>(up);
  const double from_foot = std::min(x, static_cast<double>(base_count - 1) - x);
  return x >= 0.0 && y <= tan_slope * from_foot + surface_tolerance;
}

/// Along a diagonal y grows by half sqrt3 per row and its bound by at most tan(slope)/2, so the discs in the pile have
/// no gaps. The count follows from where the diagonal meets a flank, and is then corrected for rounding.
std::int64_t count_up_left(double tan_slope, std::int64_t base_count, std::int64_t i) {
  const double left = tan_slope * static_cast<double>(i) / (half_sqrt3 + 0.5 * tan_slope);
  const double right_slack = half_sqrt3 - 0.5 * tan_slope;
  const double to_right = tan_slope * static_cast<double>(base_count - 1 - i);
  const double rows = to_right < left * right_slack ? to_right / right_slack : left;
  auto up = static_cast<std::int64_t>(rows);
  while (is_kept(tan_slope, base_count, i, up + 1)) ++up;
  while (!is_kept(tan_slope, base_count, i, up)) --up;
  return up + 1;
}

double tan_slope_of(const PileLattice& model) { return std::tan(model.slope_deg * (std::numbers::pi / 180.0)); }

BaseForce force_of_counts(std::int64_t up_left, std::int64_t up_right) {
  const auto sum = static_cast<double>(up_left + up_right);
  const auto difference = static_cast<double>(up_left - up_right);
  return {0.5 * sum, difference / (2.0 * std::numbers::sqrt3)};
}

}  // namespace

std::int64_t discs_up_left(const PileLattice& model, std::int64_t i) {
  return count_up_left(tan_slope_of(model), model.base_count, i);
}

BaseForce base_force(const PileLattice& model, std::int64_t i) {
  return force_of_counts(discs_up_left(model, i), discs_up_left(model, model.base_count - 1 - i));
}

void parameters(PileLattice& model, Parameters& to) {
  to.number("slope_deg", model.slope_deg, {.low = 0.0, .high = 60.0, .low_allowed = false}, "deg",
            "slope of both flanks");
  to.integer("base_count", model.base_count, {.low = 2, .high = 1'000'000}, "discs in the base row");
}

Table evaluate(const PileLattice& model) {
  Column x{
      "x_over_b", "1", "position of a base disc, from the centre of the first (0) to that of the last (1)", {}, {}};
  Column normal{"normal", "m g", "downward force of a base disc on the ground", {}, {}};
  Column shear{"shear", "m g", "force of a base disc on the ground to the right", {}, {}};
  const double tan_slope = tan_slope_of(model);
  const auto count = [&](std::int64_t i) { return count_up_left(tan_slope, model.base_count, i); };
  std::int64_t discs = 0;
  for (std::int64_t i = 0; i < model.base_count; ++i) {
    const auto up_left = count(i);
    const auto force = force_of_counts(up_left, count(model.base_count - 1 - i));
    discs += up_left;
    x.values.push_back(static_cast<double>(i) / static_cast<double>(model.base_count - 1));
    normal.values.push_back(force.normal);
    shear.values.push_back(force.shear);
  }
  return {{std::move(x), std::move(normal), std::move(shear)},
          {{"discs", static_cast<double>(discs), "1", "number of discs in the pile"},
           {"weight", static_cast<double>(discs), "m g", "weight of the pile: the sum of normal"}}};
}

}  // namespace repose::theory
