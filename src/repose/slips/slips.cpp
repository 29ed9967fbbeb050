// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/slips/slips.hpp"

#include "repose/analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace repose {

namespace {

using Kind = WallMotion<2>::Kind;

constexpr double part_of_mean = 1e-3;  // of the force: smaller changes are no slips
constexpr double left_out = 0.2;       // of the time since the wall set out, while the column packs
constexpr double part_of_drive = 0.1;  // of the speed that drives it: a slower wall stands

std::optional<std::size_t> driven_wall(const Record<2>& record) {
  for (const auto kind : {Kind::spring, Kind::velocity}) {
    for (std::size_t w = 0; w < record.walls.size(); ++w) {
      if (record.walls[w].wall.motion.kind == kind) return w;
    }
  }
  return std::nullopt;
}

/// The rows while the wall goes. A spring pulls with its stiffness times its length; a wall of given speed is pushed by
/// what the grains resist with, as a mean since the row before.
std::vector<DriveRow> path_of(const Record<2>& record, std::size_t w) {
  const auto& motion = record.walls[w].wall.motion;
  std::vector<DriveRow> path;
  for (std::size_t row = 0; row < record.series.size(); ++row) {
    const double time = record.series[row].time;
    if (!motion.going(time)) continue;
    const auto& at = record.wall_series[row * record.walls.size() + w];
    const double force = motion.kind == Kind::spring
                             ? motion.stiffness * (motion.speed * (time - motion.start) - at.displacement)
                             : -dot(at.force, motion.direction);
    const bool has_column = record.column_series.size() == record.series.size();
    path.push_back({time, force, at.displacement, has_column ? record.column_series[row].solid_fraction : Slips::none});
  }
  return path;
}

/// Sets how fast the wall is driven, and for how much of the time it stands.
void add_drive(const Record<2>& record, const WallMotion<2>& motion, Slips& slips) {
  slips.drive_speed = std::fabs(motion.speed);
  if (motion.kind == Kind::spring && motion.stiffness > 0.0) {
    double mass = motion.mass;
    for (const auto& grain : record.grains->line) {
      if (!grain.fixed()) mass += grain.mass;
    }
    slips.steady_speed = std::sqrt(mass / motion.stiffness) * record.scene.gravity;
  }
  const auto& path = slips.drive;
  double stuck = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double duration = path[k].time - path[k - 1].time;
    const double moved = std::fabs(path[k].displacement - path[k - 1].displacement);
    if (moved < part_of_drive * slips.drive_speed * duration) stuck += duration;
  }
  slips.stuck = stuck / (path.back().time - path.front().time);
}

}  // namespace

std::vector<Slip> find_slips(const std::vector<DriveRow>& path, double hysteresis) {
  std::vector<Slip> found;
  if (path.empty()) return found;
  std::size_t top = 0;          // largest force since the last slip
  std::size_t bottom = 0;       // smallest since then, during a slip
  double rested = Slips::none;  // displacement at the end of the slip before
  double packed = Slips::none;  // solid fraction then
  bool slipping = false;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (!slipping) {
      if (path[k].force >= path[top].force) top = k;
      if (!(path[k].force < path[top].force - hysteresis)) continue;
      slipping = true;
      bottom = k;
    } else if (path[k].force <= path[bottom].force) {
      bottom = k;
    } else if (path[k].force > path[bottom].force + hysteresis) {
      const double before = found.empty() ? Slips::none : found.back().end;
      found.push_back({path[top].time, path[bottom].time, path[top].force, path[top].force - path[bottom].force,
                       path[bottom].displacement - path[top].displacement, path[top].time - before,
                       path[top].displacement - rested, path[top].solid_fraction / path[bottom].solid_fraction - 1.0,
                       1.0 - packed / path[top].solid_fraction});
      rested = path[bottom].displacement;
      packed = path[bottom].solid_fraction;
      slipping = false;
      top = k;
    }
  }
  return found;
}

Slips slips(const Record<2>& record) {
  Slips result;
  const auto wall = driven_wall(record);
  if (!wall) {
    result.problem = "no wall is driven by a spring or at a speed";
    return result;
  }
  result.wall = record.walls[*wall].name;
  auto& path = result.drive;
  path = path_of(record, *wall);
  if (path.size() < 3) {
    path.clear();
    result.problem = "the time series has fewer than three rows while the wall goes (output.series)";
    return result;
  }
  result.from = path.front().time + left_out * (path.back().time - path.front().time);
  std::erase_if(path, [&](const auto& one) { return one.time < result.from; });
  std::vector<double> forces;
  for (const auto& one : path) forces.push_back(one.force);
  const auto force = mean_of(forces);
  result.mean_force = force.mean;
  result.deviation = force.deviation / std::fabs(force.mean);
  add_drive(record, record.walls[*wall].wall.motion, result);
  result.hysteresis = part_of_mean * std::fabs(result.mean_force);
  result.events = find_slips(path, result.hysteresis);
  double in_slips = 0.0;
  std::vector<double> drops;
  for (const auto& slip : result.events) {
    drops.push_back(slip.drop);
    in_slips += slip.end - slip.begin;
  }
  result.sliding = in_slips / (path.back().time - path.front().time);
  result.drops = fit_tail(drops);
  return result;
}

}  // namespace repose
