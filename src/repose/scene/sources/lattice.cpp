// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/lattice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace repose {

bool LatticeSource::nests(const Scene& scene) const {
  if (!scene.base->pitch()) return false;
  const double d = scene.grains.diameter;
  return is_pile() || (gap == 0.0 && scene.smallest_drawn() == d && scene.largest_drawn() == d);
}

double LatticeSource::pitch(const Scene& scene) const {
  if (nests(scene)) return std::max(*scene.base->pitch(), scene.grains.diameter);
  return is_pile() ? scene.grains.diameter : scene.largest_drawn() + gap;
}

double LatticeSource::fall(const Scene& scene) const {
  return static_cast<double>(rows) * (is_pile() ? scene.grains.diameter : pitch(scene));
}

std::string LatticeSource::describe() const {
  return is_pile() ? fmt::format("a lattice pile of {} rows", rows)
                   : fmt::format("a lattice block of {} rows of {}", rows, columns);
}

/// A pile stands on what it can stand on, and within the box.
void LatticeSource::check_pile(const Scene& scene, Problems& problems) const {
  if (!scene.base->carries_pile() && problems.sound("source.kind") && problems.sound("base.kind")) {
    std::vector<std::string> able;
    for (const auto& base : base_kinds().all()) {
      if (base->carries_pile()) able.push_back(fmt::format("\"{}\"", base->name()));
    }
    problems.problem("source.kind",
                     fmt::format(" = \"lattice\": needs a base to stand on: base.kind = {}", fmt::join(able, " or ")));
  }
  if (scene.grains.polydispersity > 0.0 && problems.sound("grains.polydispersity")) {
    problems.problem("grains.polydispersity",
                     fmt::format(" = {}: must be 0 for a lattice", scene.grains.polydispersity));
  }
  if (!scene.species.empty() && problems.sound("species")) {
    problems.problem("species", ": a lattice pile is of equal grains; source.columns makes a block of any sizes");
  }
  const double half = 0.5 * static_cast<double>(rows + 1) * pitch(scene);
  const double room = nests(scene) && scene.box.open() ? scene.base->reach(scene) : scene.box.half_width;
  if (std::fabs(x) + half > room && problems.sound("source.rows") && problems.sound("box.half_width")) {
    problems.problem("source.rows", fmt::format(" = {}: the pile must lie within x = +-{}", rows, room));
  }
}

void LatticeSource::check_block(const Scene& scene, Problems& problems) const {
  constexpr double most_grains = 1e7;
  const double grains = static_cast<double>(rows) * static_cast<double>(columns);
  if (grains > most_grains && problems.sound("source.rows")) {
    problems.problem("source.rows",
                     fmt::format(" = {}: the block would have {:.3g} grains; at most {:g}", rows, grains, most_grains));
  }
  const double width = static_cast<double>(columns) * pitch(scene);
  const double room = scene.box.half_width;
  if (!problems.sound("source.columns") || !problems.sound("box.half_width")) return;
  if (scene.box.periodic()) {
    if (width > 2.0 * room * (1.0 + 1e-9)) {
      problems.problem("source.columns", fmt::format(" = {}: the block is {:.6g} wide; the periodic box only {}",
                                                     columns, width, 2.0 * room));
    }
    return;
  }
  // Every other row stands out by half a pitch, and in hollows the block may be half a pitch off.
  const double half = 0.5 * width + (nests(scene) ? 0.75 : 0.25) * pitch(scene);
  if (std::fabs(x) + half > room) {
    problems.problem("source.columns",
                     fmt::format(" = {}: the block must lie within the box, x = +-{}; it reaches {:.6g}", columns, room,
                                 std::fabs(x) + half));
  }
}

void LatticeSource::check(const Scene& scene, Problems& problems) const {
  constexpr std::int64_t most_rows = 4000;
  if (rows > most_rows && problems.sound("source.rows")) {
    problems.problem("source.rows", fmt::format(" = {}: must be at most {}", rows, most_rows));
  }
  const double d = scene.grains.diameter;
  if (nests(scene) && problems.sound("base.spacing")) {
    if (const double spacing = *scene.base->pitch(); spacing < d || spacing > 1.5 * d) {
      problems.problem("base.spacing", fmt::format(" = {}: must be 1 to 1.5 diameters, {} to {}, under a lattice [L]",
                                                   spacing, d, 1.5 * d));
    }
  }
  is_pile() ? check_pile(scene, problems) : check_block(scene, problems);
}

}  // namespace repose
