// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_tent.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace repose::theory {

namespace {

constexpr double rounding_dip = 1e-12;

/// The lattice lines from the base up to the left that end at the corners of the surface: left foot, left break, apex,
/// right break, right foot. Between the corners lengths are linear in the position.
struct Corners {
  std::array<double, 5> foot{};    // x/B where the line meets the base
  std::array<double, 5> length{};  // of the line, in B
};

/// The distance between the feet of two lines whose ends lie on a straight part of the surface with width w and slope
/// a: w sin(60 +- a)/(cos a sin 60), with plus where the surface rises. 60 - a is computed in degrees, where it is
/// exact.
double between_feet(double width, double slope_deg, double rising) {
  return width * std::sin(radians(60.0 + rising * slope_deg)) /
         (std::sin(radians(60.0)) * std::cos(radians(slope_deg)));
}

Corners corners_of(const PileTent& model) {
  const double lower = model.break_at;
  const double upper = 0.5 - model.break_at;
  const double height_at_break = lower * std::tan(radians(model.lower_slope_deg));
  const double height = height_at_break + upper * std::tan(radians(model.upper_slope_deg));
  constexpr double per_height = 2.0 / std::numbers::sqrt3;
  Corners corners;
  corners.length = {0.0, per_height * height_at_break, per_height * height, per_height * height_at_break, 0.0};
  corners.foot[1] = between_feet(lower, model.lower_slope_deg, 1.0);
  corners.foot[2] = corners.foot[1] + between_feet(upper, model.upper_slope_deg, 1.0);
  corners.foot[3] = 1.0 - between_feet(lower, model.lower_slope_deg, -1.0);
  corners.foot[4] = 1.0;
  return corners;
}

/// The length of the line from x up to the left; `to_right_foot` is 1 - x.
double length_up_left(const Corners& corners, double x, double to_right_foot) {
  const auto& foot = corners.foot;
  const auto& length = corners.length;
  std::size_t i = 1;
  while (i < 4 && x > foot[i]) ++i;
  if (i == 4) return length[3] * to_right_foot / (1.0 - foot[3]);
  const double from = x - foot[i - 1];
  const double to = foot[i] - x;
  return (length[i - 1] * to + length[i] * from) / (from + to);
}

BaseForce force_at(const Corners& corners, double x) {
  const double up_left = length_up_left(corners, x, 1.0 - x);
  const double up_right = length_up_left(corners, 1.0 - x, x);  // the mirror image
  return {0.5 * (up_left + up_right), (up_left - up_right) / (2.0 * std::numbers::sqrt3)};
}

}  // namespace

BaseForce base_force(const PileTent& model, double x_over_b) { return force_at(corners_of(model), x_over_b); }

void parameters(PileTent& model, Parameters& to) {
  const Bounds slopes{.low = 0.0, .high = 60.0, .low_allowed = false, .high_allowed = false};
  to.number("lower_slope_deg", model.lower_slope_deg, slopes, "deg", "slope from the foot to the break");
  to.number("upper_slope_deg", model.upper_slope_deg, slopes, "deg", "slope from the break to the apex");
  to.number("break_at", model.break_at, {.low = 0.0, .high = 0.5, .low_allowed = false}, "B",
            "distance of the break from the nearer foot, along the base");
  to.integer("points", model.points, {.low = 2, .high = 1'000'000}, "positions along the base, both feet included");
}

Table evaluate(const PileTent& model) {
  const auto corners = corners_of(model);
  auto table = base_table(model.points, "chi g B", [&](double x) { return force_at(corners, x); });
  // The profile is linear between the corners and their mirror images.
  const double centre = force_at(corners, 0.5).normal;
  double peak = centre;
  for (const double x : corners.foot) peak = std::max(peak, force_at(corners, x).normal);
  const double depth = 1.0 - centre / peak;
  const bool dip = depth > rounding_dip;
  // Each lattice direction carries half of the weight. The distance between its lines is sqrt(3)/2 of their spacing on
  // the base, so the integral of the lengths over the base is the area divided by that.
  const double break_height = model.break_at * std::tan(radians(model.lower_slope_deg));
  const double rise = (0.5 - model.break_at) * std::tan(radians(model.upper_slope_deg));
  const double area = break_height * (1.0 - model.break_at) + rise * (0.5 - model.break_at);
  table.numbers = {{"weight", 2.0 / std::numbers::sqrt3 * area, "chi g B^2", "integral of normal over the base"},
                   {"centre_normal", centre, "chi g B", "normal at the centre"},
                   {"peak_normal", peak, "chi g B", "largest normal"},
                   {"dip", dip ? 1.0 : 0.0, "1", "1 if the normal force has a minimum at the centre, else 0"},
                   {"dip_depth", dip ? depth : 0.0, "1", "1 - centre_normal / peak_normal"}};
  return table;
}

}  // namespace repose::theory
