// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/source.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

constexpr Coordinates none{};

void start_keys(Scene& scene, Parameters& keys) {
  auto& start = scene.start;
  keys.text("start.from", start.from, "",
            "grains at the start: a run folder whose end it is, or a file of grains; relative to this file");
  if (start.from.empty()) return;
  keys.integer("start.step", start.step, {.low = -1},
               "of the snapshot of a file with several to start from; -1: the last");
  keys.flag("start.at_rest", start.at_rest, "they start without motion");
  if (scene.dimension == 2) {
    keys.choice("start.plane", start.plane, {"xy", "xz", "yz"},
                "of a file in three dimensions: its first axis points to the right, its second up");
    keys.number("start.tolerance", start.tolerance, {1e-6 * scene.grains.diameter, "1e-6 d"}, not_negative, "L",
                "grains may lie so far apart across the plane");
  }
  keys.number("start.scale", start.scale, positive, "", "lengths and velocities of the file are multiplied by this");
  std::vector<Word> flips{{"none", "no axis"}, {"x", "left and right change places"}};
  if (scene.dimension == 2) {
    flips.insert(flips.end(), {{"y", "up and down do"}, {"both", "both do"}});
  } else {
    flips.insert(flips.end(), {{"y", "front and back do"}, {"z", "up and down do"}});
  }
  keys.choice("start.flip", start.flip, flips, "axis whose sign changes, after the scaling");
  keys.vector("start.shift", start.shift, scene.dimension, none, "L", "is added to places, after scaling and flip");
  keys.numbers_if_any("start.fixed_types", start.fixed_types, "",
                      "grains of these types (or materials, as the file numbers them) are fixed");
}

void placed_keys(Scene& scene, Parameters& keys) {
  table_keys(keys, "grain", scene.placed, [&](Parameters& entry, PlacedGrain& grain, std::size_t) {
    entry.vector("position", grain.position, scene.dimension, std::nullopt, "L", "centre at the start");
    entry.vector("velocity", grain.velocity, scene.dimension, none, "L/T", "velocity at the start");
    if (scene.dimension == 2) {
      entry.number("spin", grain.spin[0], any, "1/T", "angular velocity, counter-clockwise");
    } else {
      entry.vector("spin", grain.spin, 3, none, "1/T", "angular velocity");
    }
    entry.number("diameter", grain.diameter, {scene.grains.diameter, "d"}, positive, "L",
                 scene.dimension == 2 ? "mass goes with its square" : "mass goes with its cube");
    entry.flag("fixed", grain.fixed, "never moves nor turns");
    material_key("material", grain.material, scene, entry);
  });
}

/// Grains that exist at the start must not lie in walls: the first of the source that does, and each placed one.
template <int D>
void check_places(const Scene& scene, Problems& problems) {
  if (!problems.none()) return;
  const auto walls = make_walls<D>(scene);
  const auto now = walls_at(walls, {}, 0.0);
  const auto box = make_box<D>(scene);
  const auto find = [&](const std::string& key, const std::string& what, const Vec<D>& place, double radius,
                        double allowed) {
    const auto wall = overlapping_wall(walls, now, box, place, radius * (1.0 - 2.0 * allowed), 1.0);
    if (!wall) return false;
    const auto at = above(walls[*wall], now[*wall], from_wall(walls[*wall], now[*wall], place, box));
    problems.problem(key,
                     fmt::format("{}wall \"{}\" presses into it by {:.3g} diameters", what, wall_names(scene)[*wall],
                                 wall_overlap(walls[*wall], at, radius) / (2.0 * radius)));
    return true;
  };
  constexpr double of_lattice = 0.01;  // diameters; a lattice is laid beside walls, and placed grains may press on them
  constexpr double of_placed = 0.1;
  Grains<D> grains;
  std::int64_t id = 0;
  if (scene.source->placed() > 0 && !walls.empty()) scene.source->add_grains(scene, grains, id);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    std::string place;
    for (int axis = 0; axis < D; ++axis) place += fmt::format("{}{:.6g}", axis > 0 ? ", " : "", grain.position[axis]);
    const auto what = fmt::format(" = \"{}\": grain at ({}) has no room: ", scene.source->name(), place);
    if (find("source.kind", what, grain.position, grain.radius, of_lattice)) break;
  }
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto& grain = scene.placed[k];
    if (grain.fixed) continue;
    find(fmt::format("grain[{}].position", k),
         fmt::format(" = {}: ", coordinates_text(grain.position, scene.dimension)), vec<D>(grain.position),
         0.5 * grain.diameter, of_placed);
  }
}

}  // namespace

void source_keys(Scene& scene, Parameters& keys) {
  const auto traits = scene.method->traits();
  if (traits.follows_time) {
    start_keys(scene, keys);
    placed_keys(scene, keys);
  }
  const auto suits = [&](const SourceKind& source) {
    return source.suits(traits) && source.in_dimension(scene.dimension);
  };
  kind_key("source.kind", scene.source, source_kinds(), suits, "none", "where grains come from", keys);
  scene.source->keys(scene, keys);
}

void check_sources(const Scene& scene, Problems& problems) {
  scene.source->check(scene, problems);
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto key = fmt::format("grain[{}].position", k);
    const auto& place = scene.placed[k].position;
    const auto says = [&] { return " = " + coordinates_text(place, scene.dimension); };
    if (std::fabs(place[0]) > scene.box.half_width && problems.sound(key) && problems.sound("box.half_width")) {
      problems.problem(key, fmt::format("{}: must lie within the box, x = +-{}", says(), scene.box.half_width));
    } else if (scene.dimension == 3 && std::fabs(place[1]) > scene.box.half_depth && problems.sound(key) &&
               problems.sound("box.half_depth")) {
      problems.problem(key, fmt::format("{}: must lie within the box, y = +-{}", says(), scene.box.half_depth));
    }
  }
  if (!scene.method->traits().follows_time) return;
  with_dimension(scene.dimension, [&](auto dimension) { check_places<dimension>(scene, problems); });
}

}  // namespace repose
