// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

namespace repose {

namespace {

constexpr std::array<double, 2> at_rest{0.0, 0.0};

void placed_keys(Scene& scene, Keys& keys) {
  table_keys<Scene::Placed>(keys, "grain", scene.placed, [&](const auto& prefix, auto& grain, std::size_t) {
    keys.vector(prefix + "position", grain.position, std::nullopt, "L", "centre at the start");
    keys.vector(prefix + "velocity", grain.velocity, at_rest, "L/T", "at the start");
    keys.number(prefix + "spin", grain.spin, 0.0, any, "1/T", "angular velocity, counter-clockwise");
    keys.number(prefix + "diameter", grain.diameter, scene.grains.diameter, positive, "L", "mass goes with its square");
    keys.flag(prefix + "fixed", grain.fixed, false, "never moves nor turns");
    material_key(prefix + "material", grain.material, scene, keys);
  });
}

void drop_keys(Scene& scene, Keys& keys) {
  auto& source = scene.source;
  const double d = scene.grains.diameter;
  const bool rain = source.kind == "rain";
  const double everywhere = scene.base.of_grains() ? scene.base.half_width : scene.box.half_width;
  keys.integer("source.count", source.count, std::nullopt, 1, "grains released in all");
  keys.number("source.rate", source.rate, required, positive, "1/T", "grains per time; the first at time 0");
  keys.number("source.height", source.height, 100.0 * d, positive, "L", "of the centres at release");
  keys.choice("source.height_above", source.height_above, "base", {"base", "apex"},
              "the height is above height 0, or above the highest grain that touches something at each release");
  keys.number("source.half_width", source.half_width, rain ? everywhere : 3.0 * d, not_negative, "L",
              "released at x +- this");
  keys.number("source.x", source.x, 0.0, any, "L", "middle of where they are released");
  keys.vector("source.velocity", source.velocity, at_rest, "L/T", "at release");
}

void sequential_keys(Scene& scene, Keys& keys) {
  auto& source = scene.source;
  const double d = scene.grains.diameter;
  const bool base = scene.base.of_grains() && scene.box.x != "periodic";
  keys.integer("source.count", source.count, 1000, 1, "grains released in all, each once all others are at rest");
  keys.number("source.height", source.height, 0.01 * d, not_negative, "L",
              "above the place where the grain first touches another or a wall on its way down");
  keys.number("source.half_width", source.half_width, base ? scene.base.half_width : scene.box.half_width, not_negative,
              "L", "released at x +- this");
  keys.number("source.x", source.x, 0.0, any, "L", "middle of where they are released");
  keys.number("source.rest", source.rest, 5e-3, positive, "g dt",
              "no grain is faster nor turns its rim faster while all are at rest");
}

void lattice_keys(Scene& scene, Keys& keys) {
  auto& source = scene.source;
  keys.integer("source.rows", source.rows, std::nullopt, 1,
               "of a block, or of the 60-degree pile: as many grains in the lowest, one less in each above");
  keys.integer("source.columns", source.columns, 0, 0, "grains in each row of a block; 0: a pile");
  keys.number("source.x", source.x, 0.0, any, "L", "of the apex, or of the middle of the block");
  if (source.columns == 0) return;
  keys.number("source.gap", source.gap, 0.0, not_negative, "L", "between grains of the largest size");
  keys.number("source.jitter", source.jitter, 0.0, {.low = 0.0, .high = 1.0}, "",
              "each grain is displaced by up to this times half the gap, so that none meet");
}

}  // namespace

void source_keys(Scene& scene, Keys& keys) {
  if (scene.method.deposits()) {
    scene.source.kind = "none";
    return keys.integer("source.count", scene.source.count, 1000, 1, "discs to deposit");
  }
  keys.text("start.from", scene.start.from, "",
            "grains there at the start: a run folder whose end it is, or a file of grains; relative to this file");
  if (!scene.start.from.empty()) {
    keys.integer("start.step", scene.start.step, -1, -1,
                 "of the snapshot of a LAMMPS dump to start from; -1: the last");
    keys.flag("start.at_rest", scene.start.at_rest, false, "they begin without motion");
  }
  placed_keys(scene, keys);
  std::vector<std::string> kinds{"pour", "rain", "lattice", "none"};
  if (scene.method.rigid()) kinds.insert(kinds.begin() + 2, "sequential");
  keys.choice("source.kind", scene.source.kind, "none", kinds,
              "where grains come from: poured from an opening, rained over a width, laid down one by one (of "
              "contact-dynamics), or there at the start as a triangular lattice");
  if (scene.source.kind == "sequential") sequential_keys(scene, keys);
  if (scene.source.kind == "lattice") lattice_keys(scene, keys);
  if (scene.source.drops()) drop_keys(scene, keys);
}

}  // namespace repose
