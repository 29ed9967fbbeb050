// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

namespace repose {

void source_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  table_keys<Scene::Placed>(keys, "grain", scene.placed, [&](const auto& prefix, auto& grain, std::size_t) {
    keys.vector(prefix + "position", grain.position, std::nullopt, "L", "centre at the start");
    keys.vector(prefix + "velocity", grain.velocity, std::array<double, 2>{0.0, 0.0}, "L/T", "at the start");
    keys.number(prefix + "spin", grain.spin, 0.0, any, "1/T", "angular velocity, counter-clockwise");
    keys.number(prefix + "diameter", grain.diameter, d, positive, "L", "mass goes with its square");
    keys.flag(prefix + "fixed", grain.fixed, false, "never moves nor turns");
    material_key(prefix + "material", grain.material, scene, keys);
  });
  keys.choice("source.kind", scene.source.kind, "none", {"pour", "lattice", "none"},
              "where grains come from: poured, or there at the start as a triangular lattice pile on the base");
  if (scene.source.kind == "lattice") {
    keys.integer("source.rows", scene.source.rows, std::nullopt, 1,
                 "of the 60-degree pile: as many grains in the lowest, one less in each above");
    keys.number("source.x", scene.source.x, 0.0, any, "L", "of the apex");
  }
  if (scene.source.kind != "pour") return;
  keys.integer("source.count", scene.source.count, std::nullopt, 1, "grains released in all");
  keys.number("source.rate", scene.source.rate, required, positive, "1/T", "grains per time; the first at time 0");
  keys.number("source.height", scene.source.height, 100.0 * d, positive, "L", "of release, above the base");
  keys.number("source.half_width", scene.source.half_width, 3.0 * d, not_negative, "L", "released at x +- this");
  keys.number("source.x", scene.source.x, 0.0, any, "L", "centre of the opening");
}

}  // namespace repose
