// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/initial.hpp"

namespace repose {

template <int D>
Grain<D> make_grain(const Scene& scene, double diameter, const std::string& material) {
  Grain<D> grain;
  grain.radius = 0.5 * diameter;
  grain.mass = scene.mass_of(diameter, material);
  grain.inverse_mass = 1.0 / grain.mass;
  return grain;
}

template <int D>
Grains<D> initial_grains(const Scene& scene) {
  Grains<D> grains;
  std::int64_t id = 0;
  scene.base->add_grains(scene, grains, id);
  add_start<D>(scene, grains, id);
  scene.source->add_grains(scene, grains, id);
  for (const auto& placed : scene.placed) {
    auto grain = make_grain<D>(scene, placed.diameter, placed.material);
    grain.position = vec<D>(placed.position);
    grain.velocity = vec<D>(placed.velocity);
    if constexpr (D == 2) {
      grain.rim_velocity = placed.spin[0] * grain.radius;
    } else {
      grain.rim_velocity = vec<3>(placed.spin) * grain.radius;
    }
    if (placed.fixed) {
      grain.inverse_mass = 0.0;
      grain.velocity = {};
      grain.rim_velocity = {};
    }
    grains.add(grain, id++, false, scene.material_number(placed.material));
  }
  return grains;
}

template Grain<2> make_grain(const Scene&, double, const std::string&);
template Grain<3> make_grain(const Scene&, double, const std::string&);
template Grains<2> initial_grains(const Scene&);
template Grains<3> initial_grains(const Scene&);

}  // namespace repose
