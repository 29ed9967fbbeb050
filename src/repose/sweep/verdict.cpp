// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/verdict.hpp"

#include "repose/analysis/holm.hpp"
#include "repose/sweep/determined.hpp"
#include "repose/sweep/height_fit.hpp"
#include "repose/sweep/point_inference.hpp"
#include "repose/sweep/table.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

std::size_t point_number(const SweepPlan& plan, const std::string& name) {
  const auto same = [&](const SweepPoint& point) { return point.name == name; };
  return static_cast<std::size_t>(std::find_if(plan.points.begin(), plan.points.end(), same) - plan.points.begin());
}

/// Sets the p-values of a claim about one statistic; they stay NaN without an error of it.
void test(Verdict& verdict, const Claim& claim) {
  const auto& p_above = verdict.inference.p_above;
  const auto& p_below = verdict.inference.p_below;
  if (!p_above) return;
  verdict.p_holds = 0.0;
  verdict.p_fails = 1.0;
  if (std::isfinite(claim.above)) {
    verdict.p_holds = std::max(verdict.p_holds, p_above(claim.above));
    verdict.p_fails = std::min(verdict.p_fails, p_below(claim.above));
  }
  if (std::isfinite(claim.below)) {
    verdict.p_holds = std::max(verdict.p_holds, p_below(claim.below));
    verdict.p_fails = std::min(verdict.p_fails, p_above(claim.below));
  }
}

std::string word_of(const Claim& claim, double p_holds, double p_fails) {
  if (std::isnan(p_holds)) return "no data";
  const bool equivalence = claim.kind == Claim::Kind::equivalence;
  if (p_holds <= test_level) return equivalence ? "equivalent" : "agrees";
  if (p_fails <= test_level) return equivalence ? "different" : "disagrees";
  return "undecided";
}

Verdict about_difference(const Claim& claim, const SweepTable& table, std::size_t measure, std::size_t first,
                         std::size_t second) {
  Verdict verdict;
  verdict.inference = infer_difference(table, measure, first, second);
  const bool paired = verdict.inference.test.starts_with("paired");
  verdict.missing = table.finished[first] + table.finished[second] - (paired ? 2 : 1) * verdict.inference.count;
  test(verdict, claim);
  return verdict;
}

/// The pair that decides: the most different one if that is enough to make the claim fail, otherwise the one for which
/// it holds least. A pair without data leaves the whole claim without.
Verdict about_equivalence(const Claim& claim, const SweepPlan& plan, const SweepTable& table, std::size_t measure) {
  std::vector<Verdict> pairs;
  for (std::size_t a = 0; a < claim.points.size(); ++a) {
    for (std::size_t b = a + 1; b < claim.points.size(); ++b) {
      pairs.push_back(about_difference(claim, table, measure, point_number(plan, claim.points[a]),
                                       point_number(plan, claim.points[b])));
      pairs.back().pair = {claim.points[a], claim.points[b]};
      if (std::isnan(pairs.back().p_holds)) return pairs.back();
    }
  }
  const auto by = [](double Verdict::*p) {
    return [p](const Verdict& first, const Verdict& second) { return first.*p < second.*p; };
  };
  const auto least_held = std::max_element(pairs.begin(), pairs.end(), by(&Verdict::p_holds));
  const auto most_different = std::min_element(pairs.begin(), pairs.end(), by(&Verdict::p_fails));
  const double p_holds = least_held->p_holds;
  const double p_fails = std::min(1.0, static_cast<double>(pairs.size()) * most_different->p_fails);
  auto deciding = p_fails <= test_level ? *most_different : *least_held;
  deciding.p_holds = p_holds;
  deciding.p_fails = p_fails;
  return deciding;
}

Verdict about_fit(const Claim& claim, const SweepTable& table) {
  Verdict verdict;
  for (const auto& fit : table.fits) {
    if (fit.name == claim.fit) verdict.inference = infer(fit, claim.measure);
  }
  test(verdict, claim);
  return verdict;
}

Verdict about(const Claim& claim, const SweepPlan& plan, const SweepTable& table) {
  if (claim.kind == Claim::Kind::fit) return about_fit(claim, table);
  const auto found = std::find(table.measures.begin(), table.measures.end(), claim.measure);
  if (found == table.measures.end()) {
    Verdict verdict;
    for (const auto& name : claim.points) verdict.missing += table.finished[point_number(plan, name)];
    return verdict;
  }
  const auto measure = static_cast<std::size_t>(found - table.measures.begin());
  const auto first = point_number(plan, claim.points.front());
  switch (claim.kind) {
    case Claim::Kind::value: {
      Verdict verdict;
      verdict.inference = infer(table, measure, first);
      verdict.missing = table.finished[first] - verdict.inference.count;
      test(verdict, claim);
      return verdict;
    }
    case Claim::Kind::difference:
      return about_difference(claim, table, measure, first, point_number(plan, claim.points[1]));
    case Claim::Kind::equivalence:
      return about_equivalence(claim, plan, table, measure);
    case Claim::Kind::fit:
      break;
  }
  return {};
}

}  // namespace

std::vector<Verdict> judge_claims(const SweepPlan& plan, const SweepTable& table) {
  std::vector<Verdict> verdicts;
  std::vector<double> holds;
  std::vector<double> fails;
  for (const auto& claim : plan.claims) {
    verdicts.push_back(about(claim, plan, table));
    holds.push_back(verdicts.back().p_holds);
    fails.push_back(verdicts.back().p_fails);
  }
  holds = holm_adjusted(holds);
  fails = holm_adjusted(fails);
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    auto& verdict = verdicts[k];
    verdict.p_holds_holm = holds[k];
    verdict.p_fails_holm = fails[k];
    verdict.word = word_of(plan.claims[k], verdict.p_holds, verdict.p_fails);
    verdict.holm_word = word_of(plan.claims[k], holds[k], fails[k]);
    if (verdict.word != "no data" && !is_determined(plan.claims[k], plan, table)) {
      verdict.word = verdict.holm_word = "not determined";
    }
  }
  return verdicts;
}

}  // namespace repose
