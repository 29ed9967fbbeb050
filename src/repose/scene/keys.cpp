// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/keys.hpp"

#include "repose/scene/scene.hpp"

namespace repose {

void show_keys(Scene& scene, Parameters& keys) {
  keys.text("title", scene.title, "", "title of the scene");
  keys.choice("units", scene.units, {"reduced", "SI"},
              "reduced: grain diameter, grain mass, gravity = 1; SI: m, kg, s");
  keys.integer("dimension", scene.dimension, {.low = 2, .high = 3},
               "2: discs in a plane, y upwards; 3: spheres, z upwards");
  keys.integer("seed", scene.seed, {.low = 0}, "seed of everything random");
  keys.number("gravity", scene.gravity, {scene.units == "SI" ? 9.81 : 1.0, "1; 9.81 in SI"}, not_negative, "L/T^2",
              "gravity");
  Coordinates down{};
  down[scene.vertical()] = -1.0;
  keys.vector("gravity_direction", scene.gravity_direction, scene.dimension, down, "",
              "of gravity, of any length; heights are measured along the last axis all the same");
  grain_keys(scene, keys);
  const auto suits = [&](const MethodKind& kind) { return kind.in_dimension(scene.dimension); };
  kind_key("method.kind", scene.method, method_kinds(), suits, usual_method, "how the grains are moved", keys);
  scene.method->keys(scene, keys);
  if (scene.method->traits().has_forces()) contact_keys(scene, keys);
  species_keys(scene, keys);
  boundary_keys(scene, keys);
  source_keys(scene, keys);
  output_keys(scene, keys);
}

}  // namespace repose
