// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/soft.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/soft.hpp"

namespace repose {

namespace {

template <int D>
SoftSettings<D> settings_of(const SoftMethod& method, const Scene& scene) {
  SoftSettings<D> settings;
  settings.time_step = method.time_step(scene);
  settings.gravity = scene.gravity_vector<D>();
  settings.box = make_box<D>(scene);
  settings.walls = make_walls<D>(scene);
  settings.synchronised = method.synchronised(scene);
  settings.audit = scene.output.energy;
  settings.skin = method.skin;
  settings.damping = {method.local_damping, method.viscous_damping};
  settings.smallest_diameter = scene.smallest_diameter();
  return settings;
}

}  // namespace

std::unique_ptr<Method<2>> SoftMethod::make(const Scene& scene, Dimension<2>) const {
  return make_soft<2>(scene.material_laws(), settings_of<2>(*this, scene));
}
std::unique_ptr<Method<3>> SoftMethod::make(const Scene& scene, Dimension<3>) const {
  return make_soft<3>(scene.material_laws(), settings_of<3>(*this, scene));
}

}  // namespace repose
