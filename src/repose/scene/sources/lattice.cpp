// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/lattice.hpp"

#include "repose/core/reproducible_math.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

namespace repose {

namespace {

constexpr std::int64_t most_rows = 4000;

/// A centre on the surface belongs to the pile, wherever rounding puts it.
constexpr double on_surface = 1e-9;  // diameters

double slope_of(double degrees) { return reproducible::tan(degrees * (std::numbers::pi / 180.0)); }

/// The multiple of the pitch, shifted, that is nearest to x.
double nearest_place(double x, double shift, double pitch) { return std::round((x - shift) / pitch) * pitch + shift; }

}  // namespace

void LatticeSource::keys(const Scene&, Parameters& keys) {
  keys.integer("source.columns", columns, {.low = 0}, "grains in each row of a block; 0: a pile");
  is_pile() ? pile_keys(keys) : block_keys(keys);
  keys.number("source.x", x, any, "L", "place of the apex, or of the middle of the block");
}

void LatticeSource::pile_keys(Parameters& keys) {
  const Bounds slopes{.low = 0.0, .high = 60.0, .low_allowed = false};
  keys.integer(
      "source.rows", rows, {.low = 0},
      "rows of a block, or of a 60-degree pile with as many grains in its lowest row and one less in each above");
  keys.integer("source.base_count", base_count, {.low = 0},
               "grains in the lowest row of a pile of any slope, instead of source.rows");
  keys.number("source.slope", slope, slopes, "deg",
              "slope of the flanks of the pile, of a tent from the foot to the break");
  keys.number("source.upper_slope", upper_slope, {slope, "source.slope"}, slopes, "deg",
              "slope of a tent from the break to the apex");
  keys.number("source.break_at", break_at, {.low = 0.0, .high = 0.5, .low_allowed = false}, "",
              "distance of the break from the nearer foot, over the length of the base between its corner centres");
  keys.flag("source.fixed_base", fixed_base,
            "the fixed grains of the base are the lowest row of the pile; else that row lies in their hollows");
}

void LatticeSource::block_keys(Parameters& keys) {
  keys.integer("source.rows", rows, std::nullopt, {.low = 1}, "rows of the block");
  keys.number("source.gap", gap, not_negative, "L", "gap between grains of the largest size");
  keys.number("source.jitter", jitter, zero_to_one, "",
              "each grain is displaced by up to this times half the gap, so that none touch");
}

bool LatticeSource::nests(const Scene& scene) const {
  if (!scene.base->pitch()) return false;
  const double d = scene.grains.diameter;
  return is_pile() || (gap == 0.0 && scene.smallest_drawn() == d && scene.largest_drawn() == d);
}

double LatticeSource::pitch(const Scene& scene) const {
  if (nests(scene)) return std::max(*scene.base->pitch(), scene.grains.diameter);
  return is_pile() ? scene.grains.diameter : scene.largest_drawn() + gap;
}

/// [diameters] height of the surface of a pile at a distance [diameters] from the nearer corner centre.
double LatticeSource::surface(double from_corner) const {
  const double to_break = break_at * static_cast<double>(lowest_count() - 1);
  if (!has_break() || from_corner <= to_break) return slope_of(slope) * from_corner;
  return slope_of(slope) * to_break + slope_of(upper_slope) * (from_corner - to_break);
}

std::vector<std::int64_t> LatticeSource::row_counts() const {
  const double rise = std::sqrt(3.0) / 2.0;
  const auto lowest = std::min(lowest_count(), most_rows);
  std::vector<std::int64_t> counts;
  for (std::int64_t row = 0; row < lowest; ++row) {
    const auto height = static_cast<double>(row) * rise;
    const auto widest = lowest - row;
    std::int64_t outside = 0;  // on each side
    const auto from_corner = [&] { return static_cast<double>(outside) + 0.5 * static_cast<double>(row); };
    while (2 * outside < widest && height > surface(from_corner()) + on_surface) ++outside;
    if (2 * outside >= widest) break;
    counts.push_back(widest - 2 * outside);
  }
  return counts;
}

double LatticeSource::middle(const Scene& scene) const {
  if (!nests(scene)) return x;
  // Grains of a row of even length, and hollows under a row of odd length, are at odd multiples of half a pitch.
  const bool odd = lowest_count() % 2 == 1;
  return nearest_place(x, odd == fixed_base ? 0.0 : 0.5 * pitch(scene), pitch(scene));
}

std::int64_t LatticeSource::placed() const {
  if (!is_pile()) return rows * columns;
  const auto counts = row_counts();
  const auto all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  return fixed_base ? all - lowest_count() : all;
}

double LatticeSource::fall(const Scene& scene) const {
  return column(scene) * (is_pile() ? scene.grains.diameter : pitch(scene));
}

double LatticeSource::column(const Scene&) const {
  return static_cast<double>(is_pile() ? std::ssize(row_counts()) : rows);
}

std::string LatticeSource::describe() const {
  if (!is_pile()) return fmt::format("a lattice block of {} rows of {}", rows, columns);
  auto text = fmt::format("a lattice pile of {} rows, {} grains wide, with flanks of {:g} deg", row_counts().size(),
                          lowest_count(), slope);
  if (has_break()) text += fmt::format(", from {:g} of its base on {:g} deg", break_at, upper_slope);
  return fixed_base ? text + "; its lowest row is the base" : text;
}

/// What the keys say of the shape of a pile, together.
void LatticeSource::check_shape(Problems& problems) const {
  if (!problems.sound("source.rows") || !problems.sound("source.base_count")) return;
  if (lowest_count() == 0) {
    problems.problem("source.rows",
                     ": missing: the rows of a 60-degree pile; or give source.base_count and source.slope");
  } else if (rows > 0 && base_count > 0) {
    problems.problem("source.base_count", fmt::format(" = {}: give this or source.rows, not both", base_count));
  } else if (rows > 0 && slope < 60.0) {
    problems.problem("source.rows",
                     fmt::format(" = {}: is for a pile of 60 degrees; give source.base_count with a slope", rows));
  } else if (base_count > most_rows) {
    problems.problem("source.base_count", fmt::format(" = {}: must be at most {}", base_count, most_rows));
  }
  if (upper_slope != slope && !has_break() && problems.sound("source.upper_slope")) {
    problems.problem("source.upper_slope",
                     fmt::format(" = {:g}: needs source.break_at, below 0.5, where it begins", upper_slope));
  }
}

/// A pile stands on what it can stand on.
void LatticeSource::check_pile(const Scene& scene, Problems& problems) const {
  check_shape(problems);
  if (!scene.base->carries_pile() && problems.sound("source.kind") && problems.sound("base.kind")) {
    std::vector<std::string> able;
    for (const auto& base : base_kinds().all()) {
      if (base->carries_pile()) able.push_back(fmt::format("\"{}\"", base->name()));
    }
    problems.problem("source.kind",
                     fmt::format(" = \"lattice\": needs a base to stand on: base.kind = {}", fmt::join(able, " or ")));
  } else if (fixed_base && !scene.base->pitch() && problems.sound("source.fixed_base")) {
    problems.problem("source.fixed_base", " = true: needs a base of fixed grains in a row, base.kind = \"row\"");
  }
  if (!scene.species.empty() && problems.sound("species")) {
    problems.problem(
        "species",
        ": grains.polydispersity spreads the sizes of a lattice pile; source.columns makes a block of species");
  }
  check_room(scene, problems);
}

/// A pile stands within the base, or within the box.
void LatticeSource::check_room(const Scene& scene, Problems& problems) const {
  const std::string key = base_count > 0 ? "source.base_count" : "source.rows";
  if (!problems.sound(key) || !problems.sound("box.half_width")) return;
  const auto count = static_cast<double>(lowest_count());
  const double room = nests(scene) && scene.box.open() ? scene.base->reach(scene) : scene.box.half_width;
  // The corner grains of a lowest row that belongs to the base are its own; another needs a grain on each side of it.
  const double reach = fixed_base ? std::fabs(middle(scene)) + 0.5 * (count - 1.0) * pitch(scene)
                                  : std::fabs(x) + 0.5 * (count + 1.0) * pitch(scene);
  if (reach <= room * (1.0 + (fixed_base ? on_surface : 0.0))) return;
  problems.problem(key, fmt::format(" = {}: the pile must lie within x = +-{}", lowest_count(), room));
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
