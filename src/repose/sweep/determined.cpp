// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/determined.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace repose {

namespace {

bool is_about_base_forces(const std::string& measure) {
  return measure == "base_dip.index" || measure == "base_scatter" || measure.starts_with("profile.");
}

/// The name of the band of a measure in the summary, "" if none is computed.
std::string band_of(const std::string& measure) {
  return measure == "base_dip.index" || measure == "profile.dip_index" ? "force_range.dip" : "";
}

/// Whether this measure of every finished member of a point is a number within bounds.
bool all_within(const SweepTable& table, std::size_t point, const std::string& measure, double low, double high) {
  const auto found = std::find(table.measures.begin(), table.measures.end(), measure);
  if (found == table.measures.end()) return false;
  const auto column = static_cast<std::size_t>(found - table.measures.begin());
  return std::all_of(table.members.begin(), table.members.end(), [&](const MemberRow& member) {
    if (member.point != point || member.status != "finished") return true;
    return column < member.values.size() && member.values[column] >= low && member.values[column] <= high;
  });
}

}  // namespace

bool is_determined(const Claim& claim, const SweepPlan& plan, const SweepTable& table) {
  if (!is_about_base_forces(claim.measure)) return true;
  for (std::size_t k = 0; k < plan.points.size(); ++k) {
    const auto& point = plan.points[k];
    if (std::find(claim.points.begin(), claim.points.end(), point.name) == claim.points.end()) continue;
    if (!point.scene.method || point.scene.method->solver() == nullptr) continue;  // springs determine their forces
    const auto band = band_of(claim.measure);
    if (claim.kind != Claim::Kind::value || band.empty()) return false;
    if (!all_within(table, k, band + ".min", claim.above, claim.below)) return false;
    if (!all_within(table, k, band + ".max", claim.above, claim.below)) return false;
  }
  return true;
}

}  // namespace repose
