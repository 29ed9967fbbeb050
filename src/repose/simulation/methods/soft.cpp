// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/soft.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/soft.hpp"

namespace repose {

std::unique_ptr<Method<2>> SoftMethod::make(const Scene& scene) const {
  SoftSettings<2> settings;
  settings.time_step = time_step(scene);
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  settings.synchronised = synchronised(scene);
  settings.audit = scene.output.energy;
  settings.skin = skin;
  settings.damping = {local_damping, viscous_damping};
  settings.smallest_diameter = scene.smallest_diameter();
  return make_soft<2>(scene.material_laws(), settings);
}

}  // namespace repose
