// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/osl.hpp"

#include "repose/core/errors.hpp"
#include "repose/core/numbers.hpp"
#include "repose/theory/linear_wedge.hpp"
#include "repose/theory/models.hpp"
#include "repose/theory/pile_continuum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace repose::theory {
namespace {

using std::numbers::pi;

/// Models of every kind with random valid angles, slopes and closures.
std::vector<Osl> random_models(bool with_ife) {
  std::mt19937 engine{20260726};
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(engine);
  };
  std::vector<Osl> models;
  const auto add = [&](const Osl& model) {
    if (relations(model).empty()) models.push_back(model);
  };
  for (int i = 0; i < 12; ++i) {
    const double angle = between(3.0, 75.0);
    const double slope = between(1.0, angle);
    for (const char* const closure : {"fpa", "bcc"}) {
      add({.model = closure, .angle_deg = angle});
      add({.model = closure, .angle_deg = angle, .slope_deg = slope});
    }
    add({.model = "custom", .angle_deg = angle, .mu = between(-3.0, 1.0)});
    add({.model = "custom",
         .angle_deg = angle,
         .slope_deg = slope,
         .mu = between(-3.0, 3.0),
         .eta = between(0.1, 3.0)});
    if (with_ife && angle > 10.0) add({.model = "ife", .angle_deg = angle});  // smaller angles have a layer at the axis
  }
  return models;
}

std::string text_of(const Osl& model) {
  std::string text;
  for (const auto& parameter : parameters_of(Model{model})) text += parameter.name + '=' + parameter.value + ' ';
  return text;
}

/// The field as printed, by depth and position: z = i/grid, x = k cot(slope)/grid.
class Field {
 public:
  explicit Field(Osl model) {
    model.output = "field";
    model.grid = grid;
    table_ = evaluate(model);
    foot_ = 1.0 / std::tan(radians(model.slope_deg.value_or(model.angle_deg)));
  }

  static constexpr int grid = 320;

  double at(const char* name, int i, int k) const {
    return table_.column(name).values.at(static_cast<std::size_t>(i * i - 1 + i + k));
  }
  /// Fourth-order central differences: exact for linear fields, accurate to 1e-9 for the smooth one.
  double over_x(const char* name, int i, int k) const {
    const double step = at("x_over_h", i, k + 1) - at("x_over_h", i, k);
    return (8.0 * (at(name, i, k + 1) - at(name, i, k - 1)) - at(name, i, k + 2) + at(name, i, k - 2)) / (12.0 * step);
  }
  double over_z(const char* name, int i, int k) const {
    return (8.0 * (at(name, i + 1, k) - at(name, i - 1, k)) - at(name, i + 2, k) + at(name, i - 2, k)) * grid / 12.0;
  }
  const Table& table() const { return table_; }
  double foot() const { return foot_; }

 private:
  Table table_;
  double foot_ = 0.0;
};

/// Whether the differences at a point extend across the kink, or across the axis, where linear stresses have one too.
bool near_kink(double s_inner, int i, int k) {
  const int wide = 2;
  const double low = (std::abs(k) - wide) / static_cast<double>(i + wide);
  const double high = (std::abs(k) + wide) / static_cast<double>(i - wide);
  return std::abs(k) <= wide || (low <= s_inner && s_inner <= high);
}

// d sxx/dx + d sxz/dz = 0 and d sxz/dx + d szz/dz = 1, from the printed field.
TEST(Osl, FieldIsInEquilibrium) {
  for (const auto& model : random_models(true)) {
    const Field field{model};
    const double s_inner = field.table().number("s_inner");
    int checked = 0;
    for (int i = 200; i + 2 <= Field::grid; i += 7) {
      for (int k = -(i - 4); k <= i - 4; k += 3) {
        if (near_kink(s_inner, i, k) && model.model != "ife") continue;
        const double across = field.over_x("horizontal", i, k) + field.over_z("shear", i, k);
        const double down = field.over_x("shear", i, k) + field.over_z("normal", i, k) - 1.0;
        ASSERT_NEAR(across, 0.0, 1e-7) << text_of(model) << i << ' ' << k;
        ASSERT_NEAR(down, 0.0, 1e-7) << text_of(model) << i << ' ' << k;
        ++checked;
      }
    }
    EXPECT_GT(checked, 500) << text_of(model);
  }
}

// There is no stress on the surface and no shear on the axis, and the pile pushes the ground outward on both sides.
TEST(Osl, FieldHasTheSymmetryAndEdgesOfAPile) {
  for (const auto& model : random_models(true)) {
    const Field field{model};
    EXPECT_EQ(field.table().column("normal").values.size(), std::size_t{Field::grid * (Field::grid + 2)});
    for (const int i : {1, 2, 63, Field::grid}) {
      EXPECT_DOUBLE_EQ(field.at("x_over_h", i, i), i * field.foot() / Field::grid);
      EXPECT_DOUBLE_EQ(field.at("z_over_h", i, 0), i / static_cast<double>(Field::grid));
      EXPECT_EQ(field.at("shear", i, 0), 0.0);
      for (const char* const stress : {"normal", "shear", "horizontal"}) {
        EXPECT_EQ(field.at(stress, i, i), 0.0);
        EXPECT_EQ(field.at(stress, i, -i), 0.0);
      }
      for (int k = 1; k < i; k += 5) {
        EXPECT_GT(field.at("shear", i, k), 0.0);
        EXPECT_EQ(field.at("shear", i, -k), -field.at("shear", i, k));
        EXPECT_EQ(field.at("normal", i, -k), field.at("normal", i, k));
      }
    }
  }
}

TEST(Osl, ObeysItsClosure) {
  for (const auto& model : random_models(false)) {
    const auto table = evaluate(model);
    for (std::size_t i = 0; i < table.column("normal").values.size(); ++i) {
      const double normal = table.column("normal").values[i];
      const double shear = table.column("shear").values[i];
      const double expected = table.number("eta") * normal + table.number("mu") * std::abs(shear);
      const double scale = normal * (1.0 + table.number("eta") + std::abs(table.number("mu")));
      EXPECT_NEAR(table.column("horizontal").values[i], expected, 1e-14 * scale) << text_of(model) << i;
    }
  }
}

TEST(Osl, StressesAreContinuousAtTheKink) {
  for (const auto& model : random_models(false)) {
    const auto table = evaluate(model);
    const double tan_slope = std::tan(radians(model.slope_deg.value_or(model.angle_deg)));
    const auto wedge = linear_wedge({.eta = table.number("eta"), .mu = table.number("mu")}, tan_slope);
    const double s = wedge.s_inner;
    EXPECT_NEAR(s, tan_slope * table.number("lambda_plus"), 1e-15);
    const auto outside = stress_on(wedge, {.from_axis = s, .from_surface = 1.0 - s});
    const auto inside = stress_on(wedge, {.from_axis = s * (1.0 - 1e-15), .from_surface = 1.0 - s});
    EXPECT_NEAR(inside.normal, outside.normal, 1e-13 * outside.normal) << text_of(model);
    EXPECT_NEAR(inside.shear, outside.shear, 1e-13 * outside.normal) << text_of(model);
    EXPECT_NEAR(inside.horizontal, outside.horizontal, 1e-13 * (outside.horizontal + outside.normal)) << text_of(model);
  }
}

// The integral is exact: trapezia between the feet, the kinks and the centre.
TEST(Osl, BaseCarriesTheWeight) {
  for (const auto& model : random_models(false)) {
    const auto table = evaluate(model);
    const double tan_slope = std::tan(radians(model.slope_deg.value_or(model.angle_deg)));
    const auto wedge = linear_wedge({.eta = table.number("eta"), .mu = table.number("mu")}, tan_slope);
    const double s = wedge.s_inner;
    const double at_kink = stress_on(wedge, {.from_axis = s, .from_surface = 1.0 - s}).normal;
    const double at_centre = stress_on(wedge, {.from_axis = 0.0, .from_surface = 1.0}).normal;
    const double weight = (0.5 * (at_centre + at_kink) * s + 0.5 * at_kink * (1.0 - s)) * 2.0 / tan_slope;
    EXPECT_NEAR(weight, 1.0 / tan_slope, 1e-12 * weight) << text_of(model);
    EXPECT_DOUBLE_EQ(table.number("weight"), 1.0 / tan_slope);
    EXPECT_DOUBLE_EQ(table.number("centre_normal"), at_centre);
    EXPECT_NEAR(table.number("peak_normal"), std::max(at_centre, at_kink), 1e-12 * at_kink) << text_of(model);
  }
}

// The lattice directions at 60 degrees are the characteristics of eta = 1/3, mu = 0. chi, the mass per length of a
// lattice line and per diameter of base, is 2/sqrt(3) of rho, which relates the units rho g h and chi g B.
TEST(Osl, LatticeClosureIsTheContinuumPileForAnyFrictionAngle) {
  for (const double slope : {0.7, 12.0, 30.0, 45.0, 58.0}) {
    const double unit = std::numbers::sqrt3 / 2.0 * 2.0 / std::tan(radians(slope));  // B/h = 2/tan(slope)
    for (const double angle : {3.0, slope, 59.0, 80.0}) {
      const auto table = evaluate(
          Osl{.model = "custom", .angle_deg = angle, .slope_deg = slope, .mu = 0.0, .eta = 1.0 / 3.0, .points = 1001});
      for (std::size_t i = 0; i < 1001; ++i) {
        const auto force = base_force(PileContinuum{.slope_deg = slope}, table.column("x_over_b").values[i]);
        EXPECT_NEAR(table.column("normal").values[i], unit * force.normal, 1e-13) << slope << ' ' << i;
        EXPECT_NEAR(table.column("shear").values[i], unit * force.shear, 1e-13) << slope << ' ' << i;
      }
    }
  }
}

// A surface steeper than the friction angle, with both parameters of the closure given, exceeds Coulomb's limit from
// some position outward. The margins of Mohr's circle of the printed stresses show where.
TEST(Osl, TooSteepASurfaceExceedsTheLimitAndIsNotRefused) {
  for (const double angle :
       {28.0, 30.0, 35.0}) {  // exceeded everywhere; everywhere except on the axis, to rounding; from some position on
    const Osl model{
        .model = "custom", .angle_deg = angle, .slope_deg = 36.0, .mu = 0.0, .eta = 1.0 / 3.0, .points = 20001};
    const auto table = evaluate(model);
    const auto& x = table.column("x_over_b").values;
    const double flank = table.number("flank_violated_from");
    double violated = 0.0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
      const double normal = table.column("normal").values[i];
      const double horizontal = table.column("horizontal").values[i];
      const double radius = std::hypot(0.5 * (normal - horizontal), table.column("shear").values[i]);
      const double margin = 1.0 - radius / (0.5 * (normal + horizontal) * std::sin(radians(angle)));
      EXPECT_NEAR(table.column("yield_margin").values[i], margin, 1e-10) << x[i];
      if (margin < 0.0) violated += 1.0;
      const double reduced = std::abs(2.0 * x[i] - 1.0);
      if (angle > 28.0 && std::abs(reduced - flank) > 1e-4) {
        EXPECT_EQ(margin<0.0, reduced> flank) << angle << ' ' << x[i];
      }
    }
    EXPECT_NEAR(violated / 20000.0, table.number("violated_share"), 2e-4);  // positions are 5e-5 apart, on two sides
    EXPECT_GT(violated, 2000.0);
  }
}

TEST(Osl, FixedPrincipalAxisHasItsClosedForms) {
  for (const double angle : {0.001, 0.5, 10.0, 30.0, 47.3, 85.0}) {
    const double s = std::sin(radians(angle));
    const auto table = evaluate(Osl{.angle_deg = angle, .points = 1001});
    EXPECT_NEAR(table.number("centre_normal"), 1.0 - s, 1e-14) << angle;
    EXPECT_NEAR(table.number("peak_normal"), (1.0 + s * s) / (1.0 + s), 1e-14) << angle;
    EXPECT_NEAR(table.number("s_inner"), s / (1.0 + s), 1e-14) << angle;
    EXPECT_EQ(table.number("dip"), 1.0);
    EXPECT_EQ(table.number("violated_share"), 0.0);
    EXPECT_NEAR(table.number("dip_depth"), 2.0 * s * s / (1.0 + s * s), 1e-14) << angle;
    const auto& normal = table.column("normal").values;
    const auto& shear = table.column("shear").values;
    const auto& horizontal = table.column("horizontal").values;
    for (std::size_t i = 1; i < 500; ++i) {
      const double axis = 0.5 * std::atan2(-2.0 * shear[i], normal[i] - horizontal[i]);
      EXPECT_NEAR(axis, 0.25 * (pi - 2.0 * radians(angle)), 1e-13 / s) << angle << ' ' << i;
    }
    EXPECT_NEAR(normal[500], horizontal[500], 1e-15) << angle;
  }
}

TEST(Osl, BouchaudCatesClaudinHasAPlateau) {
  for (const double angle : {2.0, 30.0, 61.0}) {
    const auto table = evaluate(Osl{.model = "bcc", .angle_deg = angle, .points = 1001});
    const double t = std::tan(radians(angle));
    EXPECT_NEAR(table.number("eta"), 1.0 / (1.0 + 2.0 * t * t), 1e-15);
    EXPECT_EQ(table.number("dip"), 0.0);
    for (std::size_t i = 0; i < 1001; ++i) {
      const double reduced = std::abs(2.0 * table.column("x_over_b").values[i] - 1.0);
      const bool plateau = reduced < table.number("s_inner");
      const double normal = table.column("normal").values[i];
      const double centre = table.number("centre_normal");
      EXPECT_TRUE(plateau ? normal == centre : normal <= centre * (1.0 + 1e-15)) << angle << ' ' << reduced;
    }
  }
}

// Any mu < 0 has a dip, not only fixed principal axes; any mu > 0 has its largest stress at the centre.
TEST(Osl, SignOfMuDecidesOnTheDip) {
  for (const double mu : {-2.0, -0.1, -1e-6, 1e-6, 0.1, 0.8}) {
    const auto table = evaluate(Osl{.model = "custom", .angle_deg = 35.0, .mu = mu, .points = 4001});
    const auto& normal = table.column("normal").values;
    const double peak = *std::ranges::max_element(normal);
    EXPECT_EQ(table.number("dip"), mu < 0.0 ? 1.0 : 0.0) << mu;
    EXPECT_EQ(table.number("dip_depth") > 0.0, mu < 0.0) << mu;
    EXPECT_EQ(normal[2000] < peak, mu < 0.0) << mu;
    EXPECT_EQ(normal[2000] > normal[1999], mu > 0.0) << mu;
    EXPECT_NEAR(1.0 - normal[2000] / peak, table.number("dip_depth"), 1e-3)
        << mu;  // the peak lies between two positions
  }
}

TEST(Osl, OuterRegionOfASurfaceAtTheFrictionAngleIsAtYield) {
  for (const auto& model : random_models(false)) {
    if (model.slope_deg || model.eta) continue;
    const auto table = evaluate(model);
    for (std::size_t i = 0; i < 201; ++i) {
      const double reduced = std::abs(2.0 * table.column("x_over_b").values[i] - 1.0);
      if (reduced < table.number("s_inner")) continue;
      EXPECT_NEAR(table.column("yield_margin").values[i], 0.0, 1e-12) << text_of(model);
    }
  }
}

// The violated fraction and its limits against the printed margins of a fine table.
TEST(Osl, ReportsWhereYieldIsViolated) {
  std::vector<Osl> models = random_models(true);
  models.push_back({.model = "custom", .angle_deg = 30.0, .slope_deg = 20.0, .mu = 0.0, .eta = 0.1});
  models.push_back({.model = "custom", .angle_deg = 10.0, .slope_deg = 5.0, .mu = -8.0, .eta = 1.0});
  int core = 0;
  int flank = 0;
  for (auto& model : models) {
    model.points = 20'001;
    const auto table = evaluate(model);
    const auto& margin = table.column("yield_margin").values;
    const double core_to = table.number("core_violated_to");
    const double flank_from = table.number("flank_violated_from");
    double violated = 0.0;
    for (std::size_t i = 0; i < margin.size(); ++i) {
      const double reduced = std::abs(2.0 * table.column("x_over_b").values[i] - 1.0);
      if (margin[i] < -1e-11) violated += 1.0 / static_cast<double>(margin.size());
      const bool expected = reduced < core_to || reduced > flank_from;
      const bool at_end = std::abs(margin[i]) < 1e-3;
      EXPECT_TRUE(at_end || expected == (margin[i] < 0.0)) << text_of(model) << reduced << ' ' << margin[i];
    }
    EXPECT_NEAR(table.number("violated_share"), violated, 3e-4) << text_of(model);
    EXPECT_NEAR(table.number("yield_margin_min"), *std::ranges::min_element(margin), 1e-9) << text_of(model);
    if (core_to > 0.0) ++core;
    if (flank_from >= 0.0) ++flank;
  }
  EXPECT_GT(core, 2);
  EXPECT_GT(flank, 2);
}

std::string complaint(const std::vector<Setting>& settings) {
  try {
    make_model("osl", settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Osl, RefusesParametersWithoutASolution) {
  EXPECT_EQ(complaint({{"mu", "1"}, {"eta", "2"}}),
            "osl: mu = 1: only for model = custom; model = fpa has its own\n"
            "osl: eta = 2: only for model = custom; model = fpa has its own");
  EXPECT_EQ(complaint({{"model", "custom"}, {"eta", "2"}}), "osl: mu: must be given with model = custom");
  EXPECT_EQ(complaint({{"model", "custom"}, {"mu", "0"}, {"eta", "0"}}), "osl: eta = 0: must be > 0 and <= 1000000");
  EXPECT_EQ(complaint({{"slope_deg", "31"}}),
            "osl: slope_deg = 31: must be <= angle_deg = 30, which sets the closure: no surface of cohesionless grains "
            "is steeper than the friction angle");
  EXPECT_NE(complaint({{"model", "custom"}, {"mu", "0"}, {"slope_deg", "31"}}), "none");
  EXPECT_EQ(complaint({{"model", "custom"}, {"mu", "0"}, {"eta", "0.3"}, {"slope_deg", "31"}}), "none");
  EXPECT_EQ(complaint({{"model", "ife"}, {"slope_deg", "29"}}),
            "osl: slope_deg = 29: must be angle_deg = 30 with model = ife, whose surface is also at failure");
  EXPECT_EQ(complaint({{"model", "ife"}, {"slope_deg", "30"}}), "none");
  EXPECT_EQ(complaint({{"model", "ife"}, {"angle_deg", "0.09"}}),
            "osl: angle_deg = 0.09: must be >= 0.1 with model = ife, which has a layer this thin at the axis");
  EXPECT_EQ(complaint({{"model", "custom"}, {"angle_deg", "45"}, {"mu", "2"}}),
            "osl: mu = 2: must be < 1/tan(angle_deg) = 1 if eta is not given: yield of a surface at the friction angle "
            "gives eta = -0.333333, which must be > 0");
  EXPECT_EQ(complaint({{"model", "custom"}, {"angle_deg", "45"}, {"mu", "0.5"}, {"eta", "0.75"}}),
            "osl: mu = 0.5, eta = 0.75: 1 - mu T - eta T^2 = -0.25 must be > 0 with T = tan(slope): the "
            "characteristic from the apex leaves the pile");
  EXPECT_NE(complaint({{"model", "arch"}}).find("must be fpa | bcc | ife | custom"), std::string::npos);
  EXPECT_NE(complaint({{"angle_deg", "90"}}).find("must be > 0 and < 90"), std::string::npos);
  // A stress beyond Coulomb's limit is a result and is not refused.
  EXPECT_EQ(complaint({{"model", "custom"}, {"mu", "0"}, {"eta", "0.1"}}), "none");
}

}  // namespace
}  // namespace repose::theory
