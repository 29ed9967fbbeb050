// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/analysis/inference.hpp"
#include "repose/sweep/plan.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace repose {

struct SweepTable;

/// The verdict on a claim.
struct Verdict {
  /// "agrees", "disagrees" or "undecided"; of an equivalence "equivalent", "different" or "undecided"; "not
  /// determined" where statics leaves the forces of rigid grains open; "no data" where there is no error.
  std::string word = "no data";
  std::string holm_word = "no data";         ///< the verdict with p-values adjusted for the number of claims
  Inference inference;                       ///< of the statistic; of an equivalence that of the pair that decides
  std::pair<std::string, std::string> pair;  ///< of an equivalence, the points that decide
  std::size_t missing = 0;                   ///< finished members of its points that are left out
  double p_holds = Inference::none;          ///< one-sided: the probability of such data although the claim is wrong
  double p_fails = Inference::none;          ///< one-sided: the probability of such data although the claim is right
  double p_holds_holm = Inference::none, p_fails_holm = Inference::none;
};

/// The verdicts on the claims of a plan, in their order.
///
/// A claim holds where a one-sided test excludes each of its bounds, and fails where one excludes what lies within:
/// that is, where the 95 % interval of the statistic lies within the bounds, or wholly outside. An equivalence of two
/// points is the same with the bounds -margin and margin: two one-sided tests (Schuirmann 1987, J. Pharmacokin.
/// Biopharm. 15, 657). One of several points holds if it holds for every pair, and fails if it does for one pair, with
/// a p-value multiplied by the number of pairs. Holm's rule adjusts the p-values of holding for the number of claims
/// with data, and those of failing likewise, so that neither agreement nor disagreement is found wrongly anywhere in
/// the list with a probability above 2.5 %. Validated by tests/unit/claims_test.cpp.
std::vector<Verdict> judge_claims(const SweepPlan& plan, const SweepTable& table);

/// The claims as CSV and as JSON, with the same columns.
std::string claims_csv(const SweepPlan& plan, const SweepTable& table);
std::string claims_json(const SweepPlan& plan, const SweepTable& table);

}  // namespace repose
