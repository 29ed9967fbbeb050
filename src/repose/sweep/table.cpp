// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/table.hpp"

#include "repose/analysis/statistics.hpp"

#include <utility>

namespace repose {

SweepTable make_table(const SweepPlan& plan, std::vector<std::string> measures, std::vector<MemberRow> members) {
  SweepTable table;
  table.measures = std::move(measures);
  table.members = std::move(members);
  const auto own_measures = table.measures.size();
  for (const auto& measure : profile_measures()) table.measures.emplace_back(measure.name);
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
    std::vector<EnsembleEstimate> entries;
    for (std::size_t m = 0; m < own_measures; ++m) {
      std::vector<double> values;
      for (const auto* member : finished) values.push_back(member->values[m]);
      entries.push_back(estimate_of(mean_by_t(values), mean_of(values).deviation, values.size()));
    }
    std::vector<const BaseProfile*> bases;
    for (const auto* member : finished) bases.push_back(&member->base);
    table.profiles.push_back(ensemble_profile(bases, plan.points[p].scene.analysis.base_bin));
    std::vector<const std::vector<ColumnLayer>*> columns;
    for (const auto* member : finished) columns.push_back(&member->column);
    table.columns.push_back(ensemble_column(columns));
    const auto& profile = table.profiles.back();
    const EnsembleEstimate undefined{.missing = finished.size()};
    entries.push_back(profile ? profile->dip_index : undefined);
    entries.push_back(profile ? profile->max_over_centre : undefined);
    table.entries.push_back(std::move(entries));
  }
  table.fits = fit_heights(plan, table);
  table.verdicts = judge_claims(plan, table);
  return table;
}

}  // namespace repose
