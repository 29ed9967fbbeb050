// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/height_fit.hpp"

#include "repose/scene/read.hpp"
#include "repose/sweep/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace repose {
namespace {

const std::vector<std::string> measures{"column.height",   "column.apparent_mass", "column.mass",
                                        "column.friction", "column.width",         "column.stress_ratio.mean"};

/// Columns of five heights whose floors carry 7 l_1 (1 - exp(-h/l_2)), six members each that scatter by `scatter`.
struct Columns {
  SweepPlan plan;
  std::vector<MemberRow> members;

  Columns(double lambda_1, double lambda_2, double scatter, const std::string& method = "soft") {
    HeightPlan fit;
    fit.name = "columns";
    for (const double height : {5.0, 10.0, 15.0, 20.0, 30.0}) {
      const auto name = "h" + std::to_string(plan.points.size());
      plan.points.push_back(
          {name,
           {},
           scene_from_text("method.kind = \"" + method + "\"\nstop.time = 1\n[[grain]]\nposition = [0, 3]\n",
                           "scene")});
      fit.points.push_back(name);
      const double mass = 7.0 * lambda_1 * -std::expm1(-height / lambda_2);
      for (std::int64_t seed = 1; seed <= 6; ++seed) {
        const double off = scatter * (static_cast<double>(seed) - 3.5);
        members.push_back(
            {plan.points.size() - 1, seed, "finished", {height, mass + off, 7.0 * height, 0.4, 8.0, 0.9}, {}});
      }
    }
    plan.fits.push_back(fit);
  }
  void claim(const std::string& measure, double above, double below) {
    plan.claims.push_back(
        {"a claim", "", measure, Claim::Kind::fit, plan.fits.front().points, above, below, "columns"});
  }
  SweepTable table() const { return make_table(plan, measures, members); }
};

TEST(HeightFit, FindsTheLengths) {
  const auto fit = Columns(12.0, 10.0, 0.1).table().fits.front();
  ASSERT_EQ(fit.problem, "");
  EXPECT_NEAR(fit.two.lambda_1, 12.0, 1e-6);
  EXPECT_NEAR(fit.two.lambda_2, 10.0, 1e-6);
  EXPECT_LT(fit.chance_one, 1e-9);
  EXPECT_GT(fit.chance_two, 0.99);
  const auto ratio = infer(fit, "ratio");
  EXPECT_NEAR(ratio.value, 1.2, 1e-6);
  EXPECT_GT(ratio.error, 1e-4);
  EXPECT_EQ(ratio.freedom, 25.0);
  EXPECT_NEAR(infer(fit, "stress_ratio_direct").value, 0.9, 1e-12);
  const auto one = Columns(10.0, 10.0, 0.1).table().fits.front();
  EXPECT_NEAR(infer(one, "lambda").value, 10.0, 1e-6);
  EXPECT_NEAR(infer(one, "stress_ratio").value, 8.0 / (2.0 * 0.4 * 10.0), 1e-6);
  EXPECT_NEAR(infer(one, "stress_ratio_excess").value, 1.0 - 0.9, 1e-6);
}

// The error of the ratio is that of the data: twice the scatter, twice the error.
TEST(HeightFit, ErrorsFollowTheScatterOfMembers) {
  const double narrow = infer(Columns(12.0, 10.0, 0.1).table().fits.front(), "ratio").error;
  const double wide = infer(Columns(12.0, 10.0, 0.2).table().fits.front(), "ratio").error;
  EXPECT_NEAR(wide / narrow, 2.0, 1e-6);
}

// The same claim on planted data and on contrary ones; and on rigid columns at rest, whose loads statics leaves open.
TEST(HeightFit, ContraryDataFlipTheVerdict) {
  const auto word = [](Columns columns) {
    columns.claim("ratio", 1.0, std::numeric_limits<double>::infinity());
    return columns.table().verdicts.front().word;
  };
  EXPECT_EQ(word(Columns(12.0, 10.0, 0.1)), "agrees");
  EXPECT_EQ(word(Columns(10.0, 12.0, 0.1)), "disagrees");
  EXPECT_EQ(word(Columns(10.0, 10.0, 0.1)), "undecided");
  EXPECT_EQ(word(Columns(12.0, 10.0, 0.1, "contact-dynamics")), "not determined");
}

TEST(HeightFit, NeedsMembersThatScatter) {
  auto columns = Columns(12.0, 10.0, 0.0);
  columns.claim("ratio", 1.0, std::numeric_limits<double>::infinity());
  const auto table = columns.table();
  EXPECT_NE(table.fits.front().problem, "");
  EXPECT_EQ(table.verdicts.front().word, "no data");
  EXPECT_NE(heights_csv(table.fits).find("fit,point"), std::string::npos);
}

}  // namespace
}  // namespace repose
