// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_tent.hpp"

#include "repose/theory/pile_continuum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace repose::theory {
namespace {

constexpr double sqrt3 = std::numbers::sqrt3;

double tan_of(double degrees) { return std::tan(degrees * (std::numbers::pi / 180.0)); }

double surface(const PileTent& model, double x) {
  const double from_foot = std::min(x, 1.0 - x);
  const double below = std::min(from_foot, model.break_at);
  return below * tan_of(model.lower_slope_deg) + (from_foot - below) * tan_of(model.upper_slope_deg);
}

// The length of the line at 60 degrees from x to the surface, by bisection; `side` -1 is up to the left.
double length(const PileTent& model, double x, double side) {
  double inside = 0.0;
  double outside = 2.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (inside + outside);
    const bool below = 0.5 * sqrt3 * middle < surface(model, x + 0.5 * side * middle);
    (below ? inside : outside) = middle;
  }
  return inside;
}

std::vector<PileTent> tents() {
  std::vector<PileTent> all;
  for (const double lower : {1.0, 12.0, 30.0, 47.0, 59.5}) {
    for (const double upper : {0.5, 20.0, 45.0, 59.0}) {
      for (const double break_at : {0.02, 0.2, 0.38, 0.47, 0.5}) {
        all.push_back({.lower_slope_deg = lower, .upper_slope_deg = upper, .break_at = break_at});
      }
    }
  }
  return all;
}

// Bisection resolves 1e-16 of lengths up to 1; the closed form magnifies rounding by up to 1/(1 - tan/sqrt(3)) = 70.
TEST(PileTent, EqualsLinesMeetingTheSurface) {
  for (const auto& model : tents()) {
    for (double x = 0.0; x <= 1.0; x += 1.0 / 64.0) {
      const double left = length(model, x, -1.0);
      const double right = length(model, x, 1.0);
      const auto force = base_force(model, x);
      EXPECT_NEAR(force.normal, 0.5 * (left + right), 2e-14) << x;
      EXPECT_NEAR(force.shear, (left - right) / (2.0 * sqrt3), 2e-14) << x;
    }
  }
}

// A line that is steeper than the surface meets it once, also where the pile is not convex.
TEST(PileTent, LinesMeetTheSurfaceOnce) {
  for (const auto& model : tents()) {
    for (const double x : {0.01, 0.2, 0.45, 0.5}) {
      int crossings = 0;
      bool was_inside = true;
      for (double along = 1e-4; along < 2.0; along += 1e-3) {
        const double there = x - 0.5 * along;
        const bool inside = there > 0.0 && 0.5 * sqrt3 * along < surface(model, there);
        if (inside != was_inside) ++crossings;
        was_inside = inside;
      }
      EXPECT_EQ(crossings, 1) << model.lower_slope_deg << ' ' << model.upper_slope_deg << ' ' << x;
    }
  }
}

TEST(PileTent, EqualSlopesAreTheContinuumPile) {
  for (const double slope : {0.3, 23.4, 30.0, 59.9}) {
    for (const double break_at : {0.1, 0.4, 0.5}) {
      const PileTent tent{.lower_slope_deg = slope, .upper_slope_deg = slope, .break_at = break_at};
      for (const double x : {0.003, 0.1, 0.31, 0.5, 0.77, 0.999}) {
        const auto expected = base_force(PileContinuum{.slope_deg = slope}, x);
        const auto force = base_force(tent, x);
        EXPECT_NEAR(force.normal, expected.normal, 1e-13 * expected.normal) << slope << ' ' << x;
        EXPECT_NEAR(force.shear, expected.shear, 1e-13 * expected.normal) << slope << ' ' << x;
      }
      EXPECT_EQ(evaluate(tent).number("dip"), 0.0) << slope << ' ' << break_at;
      EXPECT_EQ(evaluate(tent).number("dip_depth"), 0.0) << slope << ' ' << break_at;
    }
  }
}

// Trapezia between all kinks, which follow here from the corners of the surface, integrate the profile exactly.
TEST(PileTent, CarriesTheWeight) {
  for (const auto& model : tents()) {
    std::vector<double> kinks = {0.0, 1.0};
    for (const double corner : {model.break_at, 0.5, 1.0 - model.break_at}) {
      const double place = corner + surface(model, corner) / sqrt3;
      kinks.push_back(place);
      kinks.push_back(1.0 - place);
    }
    std::ranges::sort(kinks);
    double weight = 0.0;
    for (std::size_t i = 1; i < kinks.size(); ++i) {
      weight += 0.5 * (kinks[i] - kinks[i - 1]) *
                (base_force(model, kinks[i]).normal + base_force(model, kinks[i - 1]).normal);
    }
    EXPECT_NEAR(evaluate(model).number("weight"), weight, 1e-12 * weight);
  }
}

// The tent of the paper, Fig. 19, has a dip of 8.1 % by an independent calculation.
TEST(PileTent, PaperTentDips) {
  const auto table = evaluate(PileTent{});
  EXPECT_EQ(table.number("dip"), 1.0);
  EXPECT_NEAR(table.number("dip_depth"), 0.081, 0.0005);
}

// A dip needs a steeper upper slope, and a lattice line from the break that meets the base farther out than the one
// from the apex: b (1 + tan(lower)/sqrt(3)) + height/sqrt(3) > 1/2.
TEST(PileTent, DipsWhereTheUpperSlopeIsSteeperAndTheBreakIsHigh) {
  int dips = 0;
  for (const auto& model : tents()) {
    const double reach = model.break_at + (surface(model, model.break_at) + surface(model, 0.5)) / sqrt3;
    if (model.break_at == 0.5 || std::abs(reach - 0.5) < 1e-9) continue;
    const bool expected = model.upper_slope_deg > model.lower_slope_deg && reach > 0.5;
    const auto table = evaluate(model);
    EXPECT_EQ(table.number("dip"), expected ? 1.0 : 0.0)
        << model.lower_slope_deg << ' ' << model.upper_slope_deg << ' ' << model.break_at;
    const auto& normal = table.column("normal").values;
    EXPECT_LE(*std::ranges::max_element(normal), table.number("peak_normal") * (1.0 + 1e-14));
    if (expected) ++dips;
  }
  EXPECT_GT(dips, 10);
}

}  // namespace
}  // namespace repose::theory
