// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table.hpp"

#include <limits>
#include <utility>

namespace repose {

SweepTable make_table(const SweepPlan& plan, std::vector<std::string> measures, std::vector<MemberRow> members) {
  SweepTable table;
  table.measures = std::move(measures);
  table.members = std::move(members);
  const auto own_measures = table.measures.size();
  table.measures.insert(table.measures.end(), {"profile.dip_index", "profile.max_over_centre"});
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    std::vector<const MemberRow*> finished;
    std::size_t failed = 0;
    for (const auto& member : table.members) {
      if (member.point != p) continue;
      if (member.status == "finished") finished.push_back(&member);
      if (member.status == "failed") ++failed;
    }
    table.finished.push_back(finished.size());
    table.failed.push_back(failed);
    std::vector<Estimate> entries;
    for (std::size_t m = 0; m < own_measures; ++m) {
      std::vector<double> values;
      for (const auto* member : finished) values.push_back(member->values[m]);
      entries.push_back(mean_of(values));
    }
    std::vector<const BaseProfile*> bases;
    for (const auto* member : finished) bases.push_back(&member->base);
    table.profiles.push_back(ensemble_profile(bases, plan.points[p].scene.analysis.base_bin));
    const auto& profile = table.profiles.back();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Estimate undefined{0, none, none, none};
    entries.push_back(profile ? profile->dip_index : undefined);
    entries.push_back(profile ? profile->max_over_centre : undefined);
    table.entries.push_back(std::move(entries));
  }
  for (const auto& claim : plan.claims) table.verdicts.push_back(verdict_of(claim, plan, table));
  return table;
}

}  // namespace repose
