// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/sweep/determined.hpp"

#include "repose/core/dimension.hpp"
#include "repose/scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace repose {

namespace {

bool is_about_base_forces(const std::string& measure) {
  return measure == "base_dip.index" || measure == "base_scatter" || measure.starts_with("profile.");
}

/// Whether a number says what floor and walls of a column carry.
bool is_about_column(const Claim& claim) {
  for (const auto* part : {"apparent_mass", "load_ratio", "janssen", "wall_load", "stress_ratio", "screening_length",
                           "friction", "k_mu"}) {
    if (claim.measure.starts_with(std::string("column.") + part)) return true;
  }
  return claim.kind == Claim::Kind::fit || claim.measure.starts_with("column.fit");
}

template <int D>
bool has_moving_wall_in(const Scene& scene) {
  const auto walls = make_walls<D>(scene);
  return std::any_of(walls.begin(), walls.end(),
                     [](const auto& wall) { return wall.motion.kind != WallMotion<D>::Kind::none; });
}

/// A moving wall makes the contacts slide, again and again: what it meets is a mean over many states.
bool has_moving_wall(const Scene& scene) {
  return with_dimension(scene.dimension, [&](auto dimension) { return has_moving_wall_in<dimension>(scene); });
}

/// The name of the band of a measure in the summary, "" if none is computed.
std::string band_of(const std::string& measure) {
  if (measure == "column.load_ratio") return "force_range.load_ratio";
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
  const bool of_column = is_about_column(claim);
  if (!of_column && !is_about_base_forces(claim.measure)) return true;
  for (std::size_t k = 0; k < plan.points.size(); ++k) {
    const auto& point = plan.points[k];
    if (std::find(claim.points.begin(), claim.points.end(), point.name) == claim.points.end()) continue;
    if (!point.scene.method || point.scene.method->solver() == nullptr) continue;  // springs determine their forces
    if (of_column && has_moving_wall(point.scene)) continue;
    const auto band = band_of(claim.measure);
    if (claim.kind != Claim::Kind::value || band.empty()) return false;
    if (!all_within(table, k, band + ".min", claim.above, claim.below)) return false;
    if (!all_within(table, k, band + ".max", claim.above, claim.below)) return false;
  }
  return true;
}

}  // namespace repose
