// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/comparison/base_comparison.hpp"
#include "repose/comparison/base_overlay.hpp"
#include "repose/core/errors.hpp"
#include "repose/results/summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {
namespace {

// The continuum pile with tan(slope) = 0.4 sqrt(3). By Liffman et al. (49) the plateau begins at x/B = 0.3, where the
// shear force over the normal force is -0.4/sqrt(3) ((54)-(59) with that slope). The kink lies on a row of the table,
// so the profile is a polygon: plateau 1, feet at 0 and 1, integral 0.7, a tenth of the maximum at 0.03 and 0.97.
const double kink_slope = std::atan(0.4 * std::numbers::sqrt3) * 180.0 / std::numbers::pi;
constexpr double tenths = 0.94;
constexpr double integral = 0.7;
constexpr double plateau = 12.0;  // grain weights per length
constexpr double width = 47.0;
constexpr double middle = 0.4;

double normal_at(double x) { return plateau * std::clamp((0.5 - std::fabs((x - middle) / width)) / 0.3, 0.0, 1.0); }

double shear_at(double x) {
  const double u = (x - middle) / width;
  const double peak = 0.4 / std::numbers::sqrt3 * plateau;
  const double size = std::fabs(u) < 0.2 ? std::fabs(u) / 0.2 : std::clamp((0.5 - std::fabs(u)) / 0.3, 0.0, 1.0);
  return std::copysign(peak * size, u);
}

template <class Function>
double quadrature(const Function& function, double from, double to) {
  constexpr int steps = 20000;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k) sum += function(from + (to - from) * (k + 0.5) / steps);
  return sum * (to - from) / steps;
}

/// The base of that pile on discs at unequal distances. All bins have the error `error`.
MeasuredBase pile(double error = 0.5) {
  MeasuredBase base;
  double x = -45.0;
  for (int k = 0; x < 45.0; ++k) {
    base.discs.x.push_back(x);
    x += k % 3 == 0 ? 1.3 : 0.9;
  }
  const auto& places = base.discs.x;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double before = k == 0 ? places[1] - places[0] : places[k] - places[k - 1];
    const double after = k + 1 == places.size() ? before : places[k + 1] - places[k];
    const double from = places[k] - 0.5 * before;
    const double to = places[k] + 0.5 * after;
    base.discs.normal.push_back(quadrature(normal_at, from, to));
    base.discs.shear.push_back(quadrature(shear_at, from, to));
  }
  base.bins = binned(base.discs, 5.0);
  base.bins.normal_error.assign(base.bins.x.size(), error);
  base.bins.shear_error.assign(base.bins.x.size(), error);
  base.centre = middle;
  base.half_width = 0.5 * tenths * width;
  base.slope_deg = kink_slope;
  return base;
}

const TheoryChoice continuum{"pile-continuum", {{"points", "11"}}};

// Tolerance: that of the quadrature (step 5e-5, times the change of slope at a kink) for forces of about ten.
TEST(TheoryComparison, PileOfTheModelItselfHasNoResiduals) {
  const auto base = pile();
  const auto found = compare(continuum, base);
  EXPECT_NEAR(found.width, width, 1e-12 * width);
  EXPECT_NEAR(found.left, middle - 0.5 * width, 1e-11);
  EXPECT_NEAR(found.weight, integral * plateau * width, 1e-6);
  ASSERT_EQ(found.residuals.x.size(), 9U);  // bins at -20 ... 20: the loaded interval ends at 0.4 -+ 22.09
  EXPECT_EQ(found.residuals.x.front(), -20.0);
  for (std::size_t k = 0; k < found.residuals.x.size(); ++k) {
    EXPECT_NEAR(found.residuals.normal[k], 0.0, 1e-6);
    EXPECT_NEAR(found.residuals.shear[k], 0.0, 1e-6);
  }
  EXPECT_NEAR(found.normal.chi_square, 0.0, 1e-9);
  EXPECT_NEAR(found.shear.chi_square, 0.0, 1e-9);
  EXPECT_NEAR(found.normal.rms, 0.0, 1e-6);
}

// A picture draws the columns times `scale`, the force on a disc at the mean spacing.
TEST(TheoryComparison, ScaleGivesTheForceOnADisc) {
  const auto base = pile();
  const auto found = compare(continuum, base);
  const auto table = theory::predict(found.model);
  const double spacing = (base.discs.x.back() - base.discs.x.front()) / static_cast<double>(base.discs.x.size() - 1);
  EXPECT_NEAR(found.spacing, spacing, 1e-13);
  EXPECT_NEAR(found.scale * table.column("normal").values[5], plateau * spacing, 1e-6);
  EXPECT_NEAR(found.scale * table.column("shear").values[3], -0.4 / std::numbers::sqrt3 * plateau * spacing, 1e-6);
}

// One bin is too high by a errors and one too low by b errors, with the same total weight: chi-square is a^2 + b^2.
TEST(TheoryComparison, KnownDeviationsGiveChiSquareAndRms) {
  constexpr double error = 0.5;
  auto base = pile(error);
  const auto shift = [&](double bin, double by) {
    double count = 0.0;
    for (std::size_t k = 0; k < base.discs.x.size(); ++k) {
      if (std::floor(base.discs.x[k] / 5.0 + 0.5) == bin) count += 1.0;
    }
    for (std::size_t k = 0; k < base.discs.x.size(); ++k) {
      if (std::floor(base.discs.x[k] / 5.0 + 0.5) == bin) base.discs.normal[k] += by / count;
    }
    return by / count;
  };
  const double up = shift(-2.0, 6.0);
  const double down = shift(3.0, -6.0);
  for (auto& force : base.discs.shear) force += 1.5;
  auto bins = binned(base.discs, 5.0);
  bins.normal_error = base.bins.normal_error;
  bins.shear_error = base.bins.shear_error;
  base.bins = bins;
  const auto found = compare(continuum, base);
  EXPECT_NEAR(found.normal.chi_square, (up * up + down * down) / (error * error), 1e-4);
  EXPECT_EQ(found.normal.bins, 9);
  EXPECT_EQ(found.normal.degrees, 6);  // weight, centre and width of the normal force are matched
  EXPECT_NEAR(found.normal.rms, std::sqrt((up * up + down * down) / 9.0), 1e-6);
  EXPECT_NEAR(found.residuals.normal[2], up, 1e-6);
  EXPECT_NEAR(found.residuals.normal[7], down, 1e-6);
  EXPECT_NEAR(found.shear.chi_square, 9.0 * (1.5 / error) * (1.5 / error), 1e-4);
  EXPECT_EQ(found.shear.degrees, 9);  // nothing of the shear force is matched
  EXPECT_NEAR(found.shear.rms, 1.5, 1e-6);
  double mean = 0.0;
  for (std::size_t k = 0; k < base.bins.x.size(); ++k)
    mean += std::fabs(base.bins.x[k]) <= 20.0 ? base.bins.normal[k] / 9 : 0;
  EXPECT_NEAR(found.shear.rms_over_mean, 1.5 / mean, 1e-9);
}

TEST(TheoryComparison, BinsWithoutAnErrorDoNotCountInChiSquare) {
  auto base = pile(0.5);
  for (auto& force : base.bins.shear) force += 1.0;
  for (std::size_t k = 0; k < base.bins.x.size(); ++k) {
    if (base.bins.x[k] == 0.0) base.bins.shear_error[k] = 0.0;
    if (base.bins.x[k] == 5.0) base.bins.shear_error[k] = std::nan("");
  }
  const auto found = compare(continuum, base);
  EXPECT_EQ(found.shear.bins, 7);
  EXPECT_NEAR(found.shear.chi_square, 7.0 * 4.0, 1e-4);
  EXPECT_NEAR(found.shear.rms, 1.0, 1e-6);  // over all nine bins
}

// In a measured heap the loaded interval ends at discs, so on each side it ends up to a spacing before the tenth.
TEST(TheoryComparison, WidthFromTheMeasuredInterval) {
  auto base = pile();
  const auto dip = base_dip(base.discs);
  ASSERT_TRUE(dip);
  base.centre = dip->centre;
  base.half_width = dip->half_width;
  const auto found = compare(continuum, base);
  EXPECT_LE(found.width, width);
  EXPECT_GE(found.width, width - 2.0 * 1.3 / tenths);
  EXPECT_EQ(base.loaded_discs(),
            std::ranges::count_if(base.discs.x, [](double x) { return std::fabs(x - 0.4) < 22.2; }));
}

// A triangle with its apex at 0.2 has a tenth of the maximum at 0.02 and 0.92; the middle, 0.47, is placed on the
// centre of the heap. Two rows at one position are a jump. A foot with load ends at the foot.
TEST(TheoryComparison, SkewModelsAreCentredOnTheHeap) {
  const auto table = [](std::vector<double> x, std::vector<double> normal) {
    const std::vector<double> shear(x.size(), 0.0);
    return theory::Table{{{"x_over_b", "1", "", std::move(x), {}},
                          {"normal", "1", "", std::move(normal), {}},
                          {"shear", "1", "", shear, {}}},
                         {}};
  };
  const auto base = pile();
  auto found = compare_table(table({0.0, 0.2, 1.0}, {0.0, 1.0, 0.0}), base);
  EXPECT_NEAR(found.width, 2.0 * base.half_width / 0.9, 1e-11);
  EXPECT_NEAR(found.left + 0.47 * found.width, middle, 1e-12);
  EXPECT_NEAR(found.scale, found.weight * found.spacing / (0.5 * found.width), 1e-11);
  found = compare_table(table({0.0, 0.5, 0.5, 1.0}, {1.0, 1.0, 2.0, 2.0}), base);
  EXPECT_NEAR(found.width, 2.0 * base.half_width, 1e-11);
  // Bins at -5 and 5, left and right of the jump. Discs are 3.1/3 apart on average, a tenth more or less in a bin.
  ASSERT_EQ(base.bins.x[8], -5.0);
  ASSERT_EQ(found.residuals.x[3], -5.0);
  const double low = base.bins.normal[8] - found.residuals.normal[3];
  const double high = base.bins.normal[10] - found.residuals.normal[5];
  const double on_a_disc = found.weight / (1.5 * found.width) * (3.1 / 3.0);
  EXPECT_NEAR(low, on_a_disc, 0.1 * on_a_disc);
  EXPECT_NEAR(high, 2.0 * on_a_disc, 0.2 * on_a_disc);
}

TEST(TheoryComparison, SlopeIsThatOfTheRunUnlessGiven) {
  const auto base = pile();
  EXPECT_EQ(compare(continuum, base).from_run, std::vector<std::string>{"slope_deg"});
  EXPECT_NE(compare(continuum, base).label().find("slope_deg = 34.7150"), std::string::npos);
  const TheoryChoice own{"pile-continuum", {{"slope_deg", "20"}}};
  EXPECT_TRUE(compare(own, base).from_run.empty());
  EXPECT_EQ(compare(own, base).label(), "pile-continuum: slope_deg = 20");
  auto flat = base;
  flat.slope_deg.reset();
  EXPECT_EQ(compare(own, flat).width, compare(own, base).width);
  try {
    compare(continuum, flat);
    FAIL() << "a heap without a slope was given one";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "pile-continuum: slope_deg must be given: the heap has no angle of repose (angle_of_repose_deg.mean)");
  }
}

/// Whether a model is registered.
bool has(const std::string& name) {
  return std::ranges::any_of(theory::default_models(), [&](const auto& m) { return theory::text_of(m).name == name; });
}

// In models with a friction angle it is completed from the run, and sets the slope. If it is given, the slope is
// completed instead.
TEST(TheoryComparison, FrictionAngleIsTheSlopeUnlessGiven) {
  ASSERT_TRUE(has("osl"));
  const auto base = pile();
  using Strings = std::vector<std::string>;
  Strings taken;
  auto settings = settings_for({"osl", {{"model", "fpa"}}}, base, taken);
  EXPECT_EQ(taken, Strings{"angle_deg"});
  EXPECT_EQ(settings.back().first, "angle_deg");
  EXPECT_EQ(std::stod(settings.back().second), kink_slope);
  taken.clear();
  settings = settings_for({"osl", {{"angle_deg", "35"}}}, base, taken);
  EXPECT_EQ(taken, Strings{"slope_deg"});
  EXPECT_EQ(std::stod(settings.back().second), kink_slope);
}

TEST(TheoryComparison, LatticeHasTheLoadedDiscs) {
  ASSERT_TRUE(has("pile-lattice"));
  const auto base = pile();
  std::vector<std::string> taken;
  const auto settings = settings_for({"pile-lattice", {}}, base, taken);
  EXPECT_EQ(taken, (std::vector<std::string>{"slope_deg", "base_count"}));
  EXPECT_EQ(std::stoll(settings.back().second), base.loaded_discs());
}

TEST(TheoryComparison, ModelsOfBaseForceAreNamed) {
  auto base = pile();
  base.slope_deg.reset();
  const auto names = models_of_base_force(base);
  EXPECT_NE(std::ranges::find(names, "pile-continuum"), names.end());
  EXPECT_EQ(std::ranges::find(names, "janssen"), names.end());
}

TEST(TheoryComparison, IntervalWithoutABinIsRefused) {
  auto base = pile();
  base.centre = 2.5;
  base.half_width = 1.0;
  EXPECT_THROW(compare(continuum, base), InputError);
}

TEST(TheoryComparison, ChoicesAreReadWithAllProblems) {
  std::vector<std::string> problems;
  const auto choice = read_choice("pile-continuum:slope_deg=20,points=5", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(choice.model, "pile-continuum");
  EXPECT_EQ(choice.settings, (std::vector<theory::Setting>{{"slope_deg", "20"}, {"points", "5"}}));
  EXPECT_TRUE(read_choice("pile-continuum", problems).settings.empty());
  EXPECT_TRUE(problems.empty());
  read_choice("nonsense:a,=b,c=d", problems);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_TRUE(problems[0].starts_with("--theory nonsense:a,=b,c=d: no such model of theory; must be "));
  EXPECT_EQ(problems[1], "--theory nonsense:a,=b,c=d: a: must be key=value");
  EXPECT_EQ(problems[2], "--theory nonsense:a,=b,c=d: =b: must be key=value");
}

TEST(SummaryText, AddingAndRemovingTheoryKeepsTheRest) {
  const auto text =
      with_checksum("{\n  \"title\": \",\\n  \\\"theory\\\": 1\",\n  \"x\": {\n    \"theory\": 2\n  }\n}");
  ASSERT_TRUE(is_whole_summary(text));
  const auto with = with_theory(text, "[1]");
  EXPECT_TRUE(is_whole_summary(with));
  EXPECT_EQ(with.substr(0, with.find(",\n  \"checksum\"")),
            text.substr(0, text.find(",\n  \"checksum\"")) + ",\n  \"theory\": [1]");
  EXPECT_EQ(with_theory(with_theory(with, "[2]"), ""), text);
  EXPECT_EQ(with_theory(with, "[1]"), with);
  EXPECT_FALSE(is_whole_summary(with.substr(1)));
}

}  // namespace
}  // namespace repose
