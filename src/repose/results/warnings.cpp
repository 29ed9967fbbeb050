// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/warnings.hpp"

#include "repose/boundaries/wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

namespace {

/// Mean diameters; contacts are small against grains below it.
constexpr double deep_overlap = 0.05;

/// Fraction of the energy supplied. The automatic step leaves 2 to 3 % of what impacts dissipate
/// (docs/physics/soft.md).
constexpr double open_budget = 0.1;

using Lines = std::vector<std::string>;

template <int D>
void add_overlaps(const Record<D>& record, Lines& lines) {
  if (!record.scene.method->traits().has_forces()) return;
  const auto& rows = record.series;
  const auto deepest = std::max_element(rows.begin(), rows.end(),
                                        [](const auto& a, const auto& b) { return a.max_overlap < b.max_overlap; });
  if (deepest == rows.end() || !(deepest->max_overlap > deep_overlap)) return;
  lines.push_back(
      fmt::format("overlaps reach {:.2g} mean diameters at time {:.6g}, more than {:g}: contacts are too "
                  "soft, or the step is too long, for these speeds and loads",
                  deepest->max_overlap, deepest->time, deep_overlap));
}

template <int D>
void add_budget(const Record<D>& record, Lines& lines) {
  if (!record.scene.output.energy || record.series.empty()) return;
  const auto& energy = record.series.back().energy;
  const double supplied = std::fabs(energy.sources) + std::fabs(energy.walls_work) + std::fabs(energy.loads_work);
  if (!(std::fabs(energy.error()) > open_budget * supplied)) return;
  lines.push_back(
      fmt::format("the energy budget does not close: it misses {:.3g} of {:.3g} supplied; a smaller "
                  "method.time_step tells whether the step is too long",
                  energy.error(), supplied));
}

template <int D>
void add_solver(const Record<D>& record, Lines& lines) {
  const auto* solver = record.scene.method->solver();
  if (solver == nullptr) return;
  const auto all = solver_account(record.series);
  if (all.unconverged == 0) return;
  lines.push_back(
      fmt::format("{} of {} steps did not converge within method.most_sweeps = {}: worst residual {:.2g} g "
                  "dt, method.tolerance = {:g}; a packing creeps while that lasts",
                  all.unconverged, all.steps, solver->most_sweeps, all.worst_residual, solver->tolerance));
}

/// Grains have the side of an endless wall that its normal points to.
template <int D>
void add_behind_walls(const Record<D>& record, Lines& lines) {
  for (const auto& standing : record.walls) {
    const auto& wall = standing.wall;
    if (standing.open || wall.finite()) continue;
    std::size_t behind = 0;
    std::int64_t first = -1;
    for (std::size_t k = 0; k < record.grains.size(); ++k) {
      const auto& grain = record.grains->line[k];
      if (grain.fixed() || dot(Vec<D>(grain.position - wall.point), wall.normal) >= 0.0) continue;
      if (behind++ == 0) first = record.grains->id[k];
    }
    if (behind == 0) continue;
    lines.push_back(fmt::format("{} {} behind wall \"{}\", as grain {}: it went through, or began there", behind,
                                behind == 1 ? "grain is" : "grains are", standing.name, first));
  }
}

template <int D>
void add_crossings(const Record<D>& record, Lines& lines) {
  for (const auto& standing : record.walls) {
    const auto& crossed = standing.crossed;
    if (crossed.count == 0) continue;
    lines.push_back(fmt::format("grains went through wall \"{}\" {}: first grain {}, by time {:.6g}", standing.name,
                                crossed.count == 1 ? "once" : fmt::format("{} times", crossed.count), crossed.first,
                                crossed.time));
  }
}

template <int D>
void add_losses(const Record<D>& record, Lines& lines) {
  if (record.facts.lost == 0 || moving_count(*record.grains) > 0) return;
  lines.push_back(
      fmt::format("all {} grains have left through an open end or fallen below box.floor", record.facts.lost));
}

}  // namespace

template <int D>
std::vector<std::string> warnings_of(const Record<D>& record) {
  Lines lines = record.scene.start.warnings;
  add_overlaps(record, lines);
  add_budget(record, lines);
  add_solver(record, lines);
  add_behind_walls(record, lines);
  add_crossings(record, lines);
  add_losses(record, lines);
  return lines;
}

template std::vector<std::string> warnings_of(const Record<2>&);
template std::vector<std::string> warnings_of(const Record<3>&);

}  // namespace repose
