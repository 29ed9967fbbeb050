// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/pooled_drops.hpp"

#include "repose/sweep/csv_cells.hpp"

#include <fmt/format.h>

namespace repose {

std::vector<PooledDrops> pool_drops(const SweepPlan& plan, const SweepTable& table) {
  std::vector<PooledDrops> pooled;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    PooledDrops point{plan.points[p].name, 0, {}};
    std::vector<double> drops;
    for (const auto& member : table.members) {
      if (member.point != p || member.drops.empty()) continue;
      drops.insert(drops.end(), member.drops.begin(), member.drops.end());
      ++point.members;
    }
    if (drops.empty()) continue;
    point.fit = fit_tail(drops);
    pooled.push_back(std::move(point));
  }
  return pooled;
}

std::string drops_csv(const std::vector<PooledDrops>& pooled) {
  std::string text =
      "point,members,events,tail,x_min,exponent,error,decades,distance,p_value,exponential_ratio,exponential_p,"
      "log_normal_ratio,log_normal_p,verdict\n";
  for (const auto& [point, members, fit] : pooled) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_text(point), members, fit.events, fit.tail,
                    csv_number(fit.x_min), csv_number(fit.exponent), csv_number(fit.error), csv_number(fit.decades),
                    csv_number(fit.distance), csv_number(fit.p_value), csv_number(fit.exponential.log_ratio),
                    csv_number(fit.exponential.p_value), csv_number(fit.log_normal.log_ratio),
                    csv_number(fit.log_normal.p_value), csv_text(fit.verdict));
  }
  return text;
}

}  // namespace repose
