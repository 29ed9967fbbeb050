// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/contact_dynamics.hpp"

namespace repose {

std::unique_ptr<Method<2>> ContactDynamicsMethod::make(const Scene& scene) const {
  ContactDynamicsSettings<2> settings;
  settings.time_step = time_step(scene);
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  if (const auto limit = speed_limit(scene)) settings.speed_limit = *limit;
  settings.solver.tolerance = limits.tolerance;
  settings.solver.most_sweeps = limits.most_sweeps;
  settings.solver.accelerated = algorithm == "accelerated";
  settings.warm_start = warm_start == "never"     ? WarmStart::never
                        : warm_start == "settled" ? WarmStart::settled
                                                  : WarmStart::always;
  settings.overlap_recovery = overlap_recovery;
  settings.skin = skin;
  return make_contact_dynamics<2>(scene.impulse_laws(), settings);
}

}  // namespace repose
