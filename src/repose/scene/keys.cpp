// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/keys.hpp"

#include "repose/scene/scene.hpp"

namespace repose {

void show_keys(Scene& scene, Parameters& keys) {
  keys.text("title", scene.title, "", "title of the scene");
  keys.choice("units", scene.units, {"reduced", "SI"},
              "reduced: grain diameter, grain mass, gravity = 1; SI: m, kg, s");
  keys.integer("seed", scene.seed, {.low = 0}, "seed of everything random");
  keys.number("gravity", scene.gravity, {scene.units == "SI" ? 9.81 : 1.0, "1; 9.81 in SI"}, not_negative, "L/T^2",
              "gravity, along -y");
  grain_keys(scene, keys);
  kind_key("method.kind", scene.method, method_kinds(), any_kind, usual_method, "how the grains are moved", keys);
  scene.method->keys(scene, keys);
  if (scene.method->traits().has_forces()) contact_keys(scene, keys);
  species_keys(scene, keys);
  boundary_keys(scene, keys);
  source_keys(scene, keys);
  output_keys(scene, keys);
}

}  // namespace repose
