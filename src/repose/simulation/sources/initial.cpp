// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/initial.hpp"

namespace repose {

Grain<2> make_grain(const Scene& scene, double diameter, const std::string& material) {
  Grain<2> grain;
  grain.radius = 0.5 * diameter;
  grain.mass = scene.mass_of(diameter, material);
  grain.inverse_mass = 1.0 / grain.mass;
  return grain;
}

Grains<2> initial_grains(const Scene& scene) {
  Grains<2> grains;
  std::int64_t id = 0;
  scene.base->add_grains(scene, grains, id);
  add_start(scene, grains, id);
  scene.source->add_grains(scene, grains, id);
  for (const auto& placed : scene.placed) {
    auto grain = make_grain(scene, placed.diameter, placed.material);
    for (int k = 0; k < 2; ++k) {
      grain.position[k] = placed.position[static_cast<std::size_t>(k)];
      grain.velocity[k] = placed.velocity[static_cast<std::size_t>(k)];
    }
    grain.rim_velocity = placed.spin * grain.radius;
    if (placed.fixed) {
      grain.inverse_mass = 0.0;
      grain.velocity = {};
      grain.rim_velocity = 0.0;
    }
    grains.add(grain, id++, false, scene.material_number(placed.material));
  }
  return grains;
}

}  // namespace repose
