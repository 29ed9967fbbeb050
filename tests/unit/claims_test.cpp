// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/student.hpp"
#include "repose/scene/read.hpp"
#include "repose/sweep/table.hpp"
#include "support/sleep_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

namespace repose {
namespace {

/// A sweep with one measure, "angle", whose members are written by hand.
class SweepByHand {
 public:
  /// A point whose members have the seeds `first_seed`, `first_seed` + 1, ...
  void add(const std::string& name, const std::vector<double>& values, std::int64_t first_seed = 1) {
    add_point(name);
    for (std::size_t k = 0; k < values.size(); ++k)
      add_member(values[k], first_seed + static_cast<std::int64_t>(k), {});
  }
  void add(const std::string& name, const std::vector<BaseProfile>& bases, std::int64_t first_seed = 1) {
    add_point(name);
    for (std::size_t k = 0; k < bases.size(); ++k)
      add_member(Inference::none, first_seed + static_cast<std::int64_t>(k), bases[k]);
  }
  void claim(Claim::Kind kind, const std::vector<std::string>& points, double above, double below,
             const std::string& measure = "angle") {
    plan.claims.push_back({"a claim", "", measure, kind, points, above, below});
  }
  SweepTable table() const { return make_table(plan, {"angle"}, members); }
  Verdict verdict() const { return table().verdicts.front(); }

  SweepPlan plan;
  std::vector<MemberRow> members;

 private:
  void add_point(const std::string& name) {
    plan.points.push_back({name, {}, {}});
    plan.points.back().scene.analysis.base_bin = 5.0;
  }
  void add_member(double value, std::int64_t seed, const BaseProfile& base) {
    members.push_back({plan.points.size() - 1, seed, "finished", {value}, base});
  }
};

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Mean 2, error 0.577, t of two degrees 4.30: the interval is -0.48 to 4.48. Two standard errors are 0.85 to 3.15.
TEST(Claims, ThreeSeedsDecideByStudentsT) {
  for (const auto& [above, below, word] :
       {std::tuple{0.5, unbounded, "undecided"}, std::tuple{-0.5, unbounded, "agrees"},
        std::tuple{-0.5, 4.4, "undecided"}, std::tuple{-0.5, 4.5, "agrees"}, std::tuple{4.5, unbounded, "disagrees"},
        std::tuple{4.4, unbounded, "undecided"}, std::tuple{-unbounded, -0.5, "disagrees"}}) {
    SweepByHand sweep;
    sweep.add("one", {1.0, 2.0, 3.0});
    sweep.claim(Claim::Kind::value, {"one"}, above, below);
    EXPECT_EQ(sweep.verdict().word, word) << above << " to " << below;
    EXPECT_EQ(sweep.verdict().inference.count, 3U);
    EXPECT_EQ(sweep.verdict().inference.test, "t");
  }
}

TEST(Claims, PointsThatShareSeedsArePaired) {
  SweepByHand sweep;
  sweep.add("second", second_drug);
  sweep.add("first", first_drug);
  std::reverse(sweep.members.begin(), sweep.members.end());  // pairs are found by seed, not by place
  sweep.claim(Claim::Kind::difference, {"first", "second"}, -unbounded, 0.0);
  const auto verdict = sweep.verdict();
  EXPECT_EQ(verdict.word, "agrees");
  EXPECT_EQ(verdict.inference.test, "paired t");
  EXPECT_EQ(verdict.inference.count, 10U);
  EXPECT_EQ(verdict.missing, 0U);
  EXPECT_NEAR(verdict.inference.error, 0.3889587238883952, 1e-14);
  EXPECT_NEAR(verdict.p_holds, 0.00141644509869213637, 1e-11);
  EXPECT_NEAR(verdict.p_fails, 1.0 - 0.00141644509869213637, 1e-9);
}

// The same numbers from other seeds: Welch, and no verdict.
TEST(Claims, PointsOfOtherSeedsAreUnpaired) {
  SweepByHand sweep;
  sweep.add("first", first_drug);
  sweep.add("second", second_drug, 11);
  sweep.claim(Claim::Kind::difference, {"first", "second"}, -unbounded, 0.0);
  const auto verdict = sweep.verdict();
  EXPECT_EQ(verdict.word, "undecided");
  EXPECT_EQ(verdict.inference.test, "Welch t");
  EXPECT_EQ(verdict.inference.count, 20U);
  EXPECT_NEAR(verdict.inference.error, 0.849091017238762, 1e-14);
  EXPECT_NEAR(verdict.p_holds, 0.0396970700936790692, 1e-10);
}

// Two members lack the measure, and one has not finished: eight of nineteen finished members make no pair of values.
TEST(Claims, MissingMembersAreCounted) {
  SweepByHand sweep;
  auto first = first_drug;
  auto second = second_drug;
  first[2] = Inference::none;
  second[7] = Inference::none;
  sweep.add("first", first);
  sweep.add("second", second);
  sweep.members[4].status = "failed";
  sweep.claim(Claim::Kind::difference, {"first", "second"}, -unbounded, 0.0);
  sweep.claim(Claim::Kind::value, {"first"}, -unbounded, 10.0);
  const auto table = sweep.table();
  EXPECT_EQ(table.verdicts[0].inference.count, 7U);  // seeds 1 to 10 without 3, 5 and 8
  EXPECT_EQ(table.verdicts[0].missing, 5U);          // 9 + 10 finished, 2 x 7 in pairs
  EXPECT_EQ(table.verdicts[1].inference.count, 8U);
  EXPECT_EQ(table.verdicts[1].missing, 1U);
  EXPECT_EQ(table.finished[0], 9U);
  EXPECT_EQ(table.entries[0][0].count, 8U);
  EXPECT_EQ(table.entries[0][0].missing, 1U);
  EXPECT_EQ(table.entries[1][0].count, 9U);
  EXPECT_EQ(table.entries[1][0].missing, 1U);
  EXPECT_EQ(table.entries[0][1].count, 0U);  // no profile, as no member has a base
  EXPECT_EQ(table.entries[0][1].missing, 9U);
  const auto csv = table_csv(sweep.plan, table);
  EXPECT_EQ(csv.substr(0, csv.find("profile")),
            "point,finished,failed,angle,angle:error,angle:deviation,angle:count,angle:missing,angle:low,angle:high,");
}

// Two one-sided tests by hand: t = (mean +- margin)/error with nine degrees of freedom.
TEST(Claims, EquivalenceHasThreeOutcomes) {
  for (const auto& [margin, word, p_holds, p_fails] :
       {std::tuple{3.0, "equivalent", 0.0026555702926586685, 0.9973444297073413},
        std::tuple{2.0, "undecided", 0.15415723566909756, 0.8458427643309024},
        std::tuple{0.5, "different", 0.9892407566216127, 0.010759243378387266}}) {
    SweepByHand sweep;
    sweep.add("first", first_drug);
    sweep.add("second", second_drug);
    sweep.claim(Claim::Kind::equivalence, {"first", "second"}, -margin, margin);
    const auto verdict = sweep.verdict();
    EXPECT_EQ(verdict.word, word) << margin;
    EXPECT_NEAR(verdict.p_holds, p_holds, 1e-9) << margin;
    EXPECT_NEAR(verdict.p_fails, p_fails, 1e-9) << margin;
    EXPECT_EQ(verdict.pair, (std::pair<std::string, std::string>{"first", "second"}));
  }
}

// Three points: equivalent if each of three pairs is; different if one is, at a third of the level.
TEST(Claims, EquivalenceOfSeveralPoints) {
  SweepByHand sweep;
  sweep.add("first", first_drug);
  sweep.add("second", second_drug);
  auto third = first_drug;
  for (std::size_t k = 0; k < third.size(); ++k) third[k] += k % 2 == 0 ? 0.1 : -0.1;
  sweep.add("third", third);
  sweep.claim(Claim::Kind::equivalence, {"third", "first", "second"}, -4.0, 4.0);
  sweep.claim(Claim::Kind::equivalence, {"first", "second", "third"}, -0.5, 0.5);
  sweep.claim(Claim::Kind::equivalence, {"first", "second"}, -0.5, 0.5);
  const auto verdicts = sweep.table().verdicts;
  EXPECT_EQ(verdicts[0].word, "equivalent");
  EXPECT_EQ(verdicts[2].word, "different");
  EXPECT_NEAR(verdicts[2].p_fails, 0.010759243378387266, 1e-9);
  EXPECT_EQ(verdicts[1].word, "undecided");  // 3 x 0.0108 is above 0.025
  EXPECT_GT(verdicts[1].p_fails, 0.0251);
  EXPECT_LE(verdicts[1].p_fails, 3.0 * 0.010759243378387266 + 1e-9);
}

// Holm over the claims with data: 2 x p of the smaller, then the larger; a claim without data does not count.
TEST(Claims, HolmAdjustsForTheNumberOfClaims) {
  SweepByHand sweep;
  sweep.add("first", first_drug);
  sweep.add("second", second_drug);
  sweep.claim(Claim::Kind::difference, {"first", "second"}, -unbounded, 0.0);  // p 0.0014
  sweep.claim(Claim::Kind::value, {"second"}, 0.9, unbounded);
  sweep.claim(Claim::Kind::value, {"second"}, 0.0, unbounded, "no such measure");
  const auto verdicts = sweep.table().verdicts;
  // second: mean 2.33, error 0.6332: t = 2.258 of nine degrees, p = 0.0252.
  const double p = student_probability(-(2.33 - 0.9) / (2.002248735796829 / std::sqrt(10.0)), 9.0);
  EXPECT_NEAR(verdicts[1].p_holds, p, 1e-6);
  EXPECT_NEAR(verdicts[0].p_holds_holm, 2.0 * verdicts[0].p_holds, 1e-12);
  EXPECT_NEAR(verdicts[1].p_holds_holm, verdicts[1].p_holds, 1e-12);
  EXPECT_EQ(verdicts[0].holm_word, "agrees");
  EXPECT_EQ(verdicts[2].word, "no data");
  EXPECT_EQ(verdicts[2].holm_word, "no data");
  EXPECT_EQ(verdicts[2].missing, 10U);
  EXPECT_TRUE(std::isnan(verdicts[2].p_holds_holm));
}

TEST(Claims, AVerdictMayFallToTheNumberOfClaims) {
  SweepByHand sweep;
  sweep.add("first", first_drug);
  sweep.add("second", second_drug);
  for (int k = 0; k < 20; ++k) sweep.claim(Claim::Kind::difference, {"first", "second"}, -unbounded, 0.0);
  const auto verdict = sweep.verdict();
  EXPECT_EQ(verdict.word, "agrees");
  EXPECT_NEAR(verdict.p_holds_holm, 20.0 * verdict.p_holds, 1e-9);  // 0.028
  EXPECT_EQ(verdict.holm_word, "undecided");
}

/// A load of 0.9 on discs from -20 to 20, with `centre` on |x| <= 2, `aside` on 3 to 5 and `further` on 6 to 8: the
/// three inner rings of 0.15 half-widths.
BaseProfile ringed(double centre, double aside = 1.0, double further = 1.0) {
  BaseProfile base;
  for (int k = -20; k <= 20; ++k) {
    const int place = std::abs(k);
    base.id.push_back(k);
    base.x.push_back(k);
    base.normal.push_back(place <= 2 ? centre : place <= 5 ? aside : place <= 8 ? further : 0.9);
    base.shear.push_back(0.0);
  }
  return base;
}

// The largest of two rings whose noise is opposed is 1 + |mean noise|: half normal, bias sqrt(2/pi) errors of that
// mean. Tolerance: three errors of 9999 resamples (1.5 %), and the coarse mean of 12 draws (3 %).
TEST(Claims, TheLargestRingStatesItsBias) {
  std::vector<BaseProfile> bases;
  double squares = 0.0;
  for (int k = 0; k < 12; ++k) {
    const double noise = 0.02 * normal_quantile((k + 0.5) / 12.0);
    squares += noise * noise;
    bases.push_back(ringed(1.0, 1.0 + noise, 1.0 - noise));
  }
  SweepByHand sweep;
  sweep.add("one", bases);
  const auto entry = sweep.table().entries[0][2];
  const double error = std::sqrt(squares / 11.0 / 12.0);
  EXPECT_NEAR(entry.mean, 1.0, 1e-12);
  // The bias of resamples is smaller by sqrt(11/12) and widened by 12/11, as that of a smooth statistic is.
  EXPECT_NEAR(entry.bias, std::sqrt(2.0 / std::numbers::pi) * error * std::sqrt(12.0 / 11.0), 0.05 * error);
  EXPECT_EQ(entry.count, 12U);
  EXPECT_EQ(entry.missing, 0U);
}

// The dip index of the mean is about 1/(mean of the centres c): error s_c/sqrt(n)/c^2, within the 0.7 % of 9999
// resamples (three times) and the curvature of 1/c, of order (0.02)^2.
TEST(Claims, TheDipOfTheMeanHasTheErrorOfItsRatio) {
  std::vector<BaseProfile> bases;
  for (int k = 0; k < 10; ++k) bases.push_back(ringed(0.8 + 0.02 * normal_quantile((k + 0.5) / 10.0)));
  SweepByHand sweep;
  sweep.add("one", bases);
  const auto entry = sweep.table().entries[0][1];
  double squares = 0.0;
  double outer = 0.0;
  double inner = 0.0;
  for (const auto& base : bases) squares += std::pow(base.normal[20] - 0.8, 2);
  // |x| <= 3 within 0.15 half-widths of 20: five discs of c and two of 1; the others up to |x| = 9: five of 1, one of
  // 0.9.
  inner = (5.0 * 0.8 + 2.0) / 7.0;
  outer = (5.0 + 0.9) / 6.0;
  const double error = std::sqrt(squares / 9.0 / 10.0) * 5.0 / 7.0;
  EXPECT_NEAR(entry.mean, outer / inner, 1e-12);
  EXPECT_NEAR(entry.error, outer / (inner * inner) * error, 0.022 * outer / (inner * inner) * error);
  EXPECT_LT(entry.low, entry.mean - entry.error);
  EXPECT_GT(entry.high, entry.mean + entry.error);
}

// Both points have the same centres seed by seed, one with a load 1 % larger at the sides: paired, the difference is
// sharp; from other seeds it is lost in the scatter of 10 %.
TEST(Claims, DipsOfSharedSeedsArePaired) {
  std::vector<BaseProfile> plain;
  std::vector<BaseProfile> raised;
  for (int k = 0; k < 8; ++k) {
    const double centre = 0.8 + 0.08 * normal_quantile((k + 0.5) / 8.0);
    plain.push_back(ringed(centre));
    raised.push_back(ringed(centre, 1.01, 1.01));
  }
  for (const bool shared : {true, false}) {
    SweepByHand sweep;
    sweep.add("raised", raised);
    sweep.add("plain", plain, shared ? 1 : 9);
    sweep.claim(Claim::Kind::difference, {"raised", "plain"}, 0.0, unbounded, "profile.dip_index");
    const auto verdict = sweep.verdict();
    EXPECT_EQ(verdict.word, shared ? "agrees" : "undecided");
    EXPECT_EQ(verdict.inference.test, shared ? "paired bootstrap" : "unpaired bootstrap");
    EXPECT_EQ(verdict.inference.count, shared ? 8U : 16U);
    EXPECT_EQ(verdict.missing, 0U);
  }
}

// Statics leaves the base forces of rigid grains open: no claim on them stands without the band of every member.
TEST(Claims, BaseForcesOfRigidGrainsAreNotDetermined) {
  const auto verdict = [](const char* method, double lowest, double highest, const std::string& measure) {
    SweepByHand sweep;
    sweep.add("one", {1.4, 1.5, 1.6});
    sweep.plan.points.back().scene = scene_from_text(
        "method.kind = \"" + std::string(method) + "\"\nstop = { time = 1 }\n[[grain]]\nposition = [0, 1]\n",
        "scene.toml");
    for (auto& member : sweep.members) member.values = {member.values[0], lowest, highest};
    sweep.claim(Claim::Kind::value, {"one"}, 1.0, 2.0, measure);
    return make_table(sweep.plan, {measure, "force_range.dip.min", "force_range.dip.max"}, sweep.members)
        .verdicts.front();
  };
  const double unknown = Inference::none;
  EXPECT_EQ(verdict("soft", unknown, unknown, "base_dip.index").word, "agrees");
  EXPECT_EQ(verdict("contact-dynamics", unknown, unknown, "coordination").word, "agrees");
  EXPECT_EQ(verdict("contact-dynamics", unknown, unknown, "base_dip.index").word, "not determined");
  EXPECT_EQ(verdict("contact-dynamics", 0.04, 10.5, "base_dip.index").word, "not determined");
  EXPECT_EQ(verdict("contact-dynamics", 1.1, 1.9, "base_dip.index").word, "agrees");
  EXPECT_EQ(verdict("contact-dynamics", 1.1, 1.9, "base_scatter").holm_word, "not determined");
}

TEST(Claims, CsvAndJsonHaveTheSameColumns) {
  SweepByHand sweep;
  sweep.add("first", first_drug);
  sweep.add("second", second_drug);
  sweep.claim(Claim::Kind::equivalence, {"first", "second"}, -3.0, 3.0);
  const auto csv = claims_csv(sweep.plan, sweep.table());
  std::istringstream heads(csv.substr(0, csv.find('\n')));
  const auto json = claims_json(sweep.plan, sweep.table());
  std::string head;
  std::size_t at = 0;
  while (std::getline(heads, head, ',')) {
    at = json.find("\"" + head + "\":", at);
    EXPECT_NE(at, std::string::npos) << head;
  }
  EXPECT_NE(csv.find("a claim,,angle,equivalence,first second,-3,3,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",paired t,10,0,first second,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace repose
