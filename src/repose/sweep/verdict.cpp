// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

Verdict verdict_of(const Claim& claim, const SweepPlan& plan, const SweepTable& table) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto column = std::find(table.measures.begin(), table.measures.end(), claim.measure) - table.measures.begin();
  const auto entry = [&](const std::string& name) {
    const auto same = [&](const SweepPoint& point) { return point.name == name; };
    const auto point = std::find_if(plan.points.begin(), plan.points.end(), same) - plan.points.begin();
    const auto missing = static_cast<std::size_t>(column) == table.measures.size();
    return missing ? Estimate{0, none, none, none}
                   : table.entries[static_cast<std::size_t>(point)][static_cast<std::size_t>(column)];
  };
  Verdict verdict{"no data", none, none};
  switch (claim.kind) {
    case Claim::Kind::value: {
      const auto only = entry(claim.points.front());
      verdict.value = only.mean;
      verdict.error = only.error;
      break;
    }
    case Claim::Kind::difference: {
      const auto first = entry(claim.points[0]);
      const auto second = entry(claim.points[1]);
      verdict.value = first.mean - second.mean;
      verdict.error = std::hypot(first.error, second.error);
      break;
    }
    case Claim::Kind::spread: {
      std::vector<Estimate> all;
      for (const auto& name : claim.points) all.push_back(entry(name));
      const auto undefined = [](const Estimate& estimate) { return std::isnan(estimate.mean); };
      if (std::any_of(all.begin(), all.end(), undefined)) return verdict;
      const auto less = [](const Estimate& a, const Estimate& b) { return a.mean < b.mean; };
      const auto [low, high] = std::minmax_element(all.begin(), all.end(), less);
      verdict.value = high->mean - low->mean;
      verdict.error = std::hypot(high->error, low->error);
      break;
    }
  }
  if (std::isnan(verdict.value) || std::isnan(verdict.error)) return verdict;
  const double low = verdict.value - 2.0 * verdict.error;
  const double high = verdict.value + 2.0 * verdict.error;
  if (low >= claim.above && high <= claim.below) {
    verdict.word = "agrees";
  } else if (high < claim.above || low > claim.below) {
    verdict.word = "disagrees";
  } else {
    verdict.word = "undecided";
  }
  return verdict;
}

}  // namespace repose
