// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/source.hpp"

#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

constexpr std::array<double, 2> none{0.0, 0.0};

void start_keys(StartFrom& start, Parameters& keys) {
  keys.text("start.from", start.from, "",
            "grains at the start: a run folder whose end it is, or a file of grains; relative to this file");
  if (start.from.empty()) return;
  keys.integer("start.step", start.step, {.low = -1}, "of the snapshot of a LAMMPS dump to start from; -1: the last");
  keys.flag("start.at_rest", start.at_rest, "they start without motion");
}

void placed_keys(Scene& scene, Parameters& keys) {
  table_keys(keys, "grain", scene.placed, [&](Parameters& entry, PlacedGrain& grain, std::size_t) {
    entry.vector("position", grain.position, std::nullopt, "L", "centre at the start");
    entry.vector("velocity", grain.velocity, none, "L/T", "velocity at the start");
    entry.number("spin", grain.spin, any, "1/T", "angular velocity, counter-clockwise");
    entry.number("diameter", grain.diameter, {scene.grains.diameter, "d"}, positive, "L", "mass goes with its square");
    entry.flag("fixed", grain.fixed, "never moves nor turns");
    material_key("material", grain.material, scene, entry);
  });
}

}  // namespace

void source_keys(Scene& scene, Parameters& keys) {
  const auto traits = scene.method->traits();
  if (traits.follows_time) {
    start_keys(scene.start, keys);
    placed_keys(scene, keys);
  }
  const auto suits = [&](const SourceKind& source) { return source.suits(traits); };
  kind_key("source.kind", scene.source, source_kinds(), suits, "none", "where grains come from", keys);
  scene.source->keys(scene, keys);
}

void check_sources(const Scene& scene, Problems& problems) {
  scene.source->check(scene, problems);
  for (std::size_t k = 0; k < scene.placed.size(); ++k) {
    const auto key = fmt::format("grain[{}].position", k);
    const auto& place = scene.placed[k].position;
    if (std::fabs(place[0]) > scene.box.half_width && problems.sound(key) && problems.sound("box.half_width")) {
      problems.problem(
          key, fmt::format(" = [{}, {}]: must lie within the box, x = +-{}", place[0], place[1], scene.box.half_width));
    }
  }
}

}  // namespace repose
