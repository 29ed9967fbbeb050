// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/janssen.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace repose::theory {
namespace {

Janssen column(std::int64_t dimension, const std::string& direction) {
  return {.dimension = dimension,
          .width = 0.7,
          .stress_ratio = 0.45,
          .friction = 0.62,
          .solid_fraction = 0.58,
          .density = 2.5,
          .gravity = 9.8,
          .height = 3.1,
          .direction = direction,
          .overload = 4.0};
}

// One slice of the column after the other: the stress grows by the weight of a slice minus the force of its walls,
// computed from the perimeter and the area of the cross-section instead of the screening length. The midpoint rule is
// of second order, so two step sizes give the limit to their fourth power.
double by_slices(const Janssen& model, int slices) {
  const bool slit = model.dimension == 2;
  const double cross_section = slit ? model.width : std::numbers::pi * std::pow(0.5 * model.width, 2);
  const double perimeter = slit ? 2.0 : std::numbers::pi * model.width;
  const double sense = model.direction == "rest" ? 1.0 : -1.0;
  const double dz = model.height / slices;
  double stress = model.overload;
  for (int i = 0; i < slices; ++i) {
    const auto growth = [&](double s) {
      const double weight = model.density * model.solid_fraction * model.gravity * cross_section;
      return (weight - sense * model.friction * model.stress_ratio * s * perimeter) / cross_section;
    };
    stress += dz * growth(stress + 0.5 * dz * growth(stress));
  }
  return stress;
}

// The extrapolated sum of 20000 slices is accurate to about (x/20000)^3 with x = 10 at most: 1e-10.
TEST(Janssen, BalancesTheForcesOnEverySlice) {
  for (const std::int64_t dimension : {2, 3}) {
    for (const auto* direction : {"rest", "pushed-up"}) {
      const auto model = column(dimension, direction);
      const double limit = (4.0 * by_slices(model, 20000) - by_slices(model, 10000)) / 3.0;
      EXPECT_NEAR(vertical_stress(model, model.height), limit, 1e-9 * limit) << dimension << direction;
    }
  }
}

// The force on the walls, by quadrature, plus the force on the bottom is the weight plus the overload.
TEST(Janssen, WallsAndBottomCarryTheWeight) {
  for (const std::int64_t dimension : {2, 3}) {
    for (const double sense : {1.0, -1.0}) {
      const auto model = column(dimension, sense > 0.0 ? "rest" : "pushed-up");
      const double perimeter = dimension == 2 ? 2.0 : std::numbers::pi * model.width;
      const double walls = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [&](double depth) { return model.friction * model.stress_ratio * vertical_stress(model, depth) * perimeter; },
          0.0, model.height, 10, 1e-13);
      const double weight = model.density * model.solid_fraction * model.gravity * area(model) * model.height;
      const double load = weight + model.overload * area(model);
      EXPECT_NEAR(vertical_stress(model, model.height) * area(model) + sense * walls, load, 1e-11 * (load + walls));
    }
  }
}

// Without friction the column is exactly hydrostatic. With very little friction, the walls carry the first term of the
// series.
TEST(Janssen, HydrostaticLimit) {
  auto model = column(3, "rest");
  model.overload = 0.0;
  const double weight = 2.5 * 0.58 * 9.8;
  model.friction = 0.0;
  for (const double depth : {1e-9, 0.3, 3.1}) EXPECT_DOUBLE_EQ(vertical_stress(model, depth), weight * depth);
  EXPECT_EQ(screening_length(model), std::numeric_limits<double>::infinity());
  for (const double friction : {1e-17, 1e-9}) {
    model.friction = friction;
    for (const auto& [direction, sense] : {std::pair{"rest", 1.0}, std::pair{"pushed-up", -1.0}}) {
      model.direction = direction;
      const double x = sense * 3.1 * 4.0 * 0.45 * friction / 0.7;
      const double expected = weight * 3.1 * (1.0 - 0.5 * x);
      EXPECT_NEAR(vertical_stress(model, 3.1), expected, 1e-15 * expected) << friction << direction;
    }
  }
}

TEST(Janssen, ApparentMassHasNoGravity) {
  auto model = column(3, "rest");
  model.overload = 0.0;
  const double mass = 0.25 * std::numbers::pi * 0.49 * 0.58 * 2.5 * 0.7 / (4.0 * 0.45 * 0.62);
  for (const double gravity : {1.6, 9.8}) {
    model.gravity = gravity;
    model.height = 40.0;
    const auto table = evaluate(model);
    EXPECT_NEAR(table.number("saturation_mass"), mass, 1e-14 * mass);
    EXPECT_NEAR(table.column("apparent_mass").values.back(), mass, 1e-13 * mass);  // exp(-64) is below rounding
    EXPECT_NEAR(table.number("saturation_stress") * area(model), mass * gravity, 1e-13 * mass * gravity);
  }
  model.dimension = 2;
  const double in_slit = 0.7 * 0.58 * 2.5 * 0.7 / (2.0 * 0.45 * 0.62);
  EXPECT_NEAR(evaluate(model).number("saturation_mass"), in_slit, 1e-14 * in_slit);
  EXPECT_EQ(evaluate(model).column("apparent_mass").unit, "M/L");
  model.direction = "pushed-up";
  EXPECT_EQ(evaluate(model).number("saturation_mass"), std::numeric_limits<double>::infinity());
}

TEST(Janssen, RefusesAnOverflow) {
  auto model = column(3, "pushed-up");
  model.height = 699.9 * screening_length(model);
  EXPECT_TRUE(relations(model).empty());
  EXPECT_TRUE(std::isfinite(evaluate(model).column("stress").values.back()));
  model.height = 700.1 * screening_length(model);
  EXPECT_EQ(relations(model).size(), 1u);
  model.direction = "rest";
  EXPECT_TRUE(relations(model).empty());
}

}  // namespace
}  // namespace repose::theory
