// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/hybrid.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/hybrid.hpp"

#include <cmath>

namespace repose {

std::unique_ptr<Method<2>> HybridMethod::make(const Scene& scene, Dimension<2>) const {
  const double d = scene.grains.diameter;
  const double mass = scene.nominal_mass();
  HybridSettings settings;
  settings.time_step = time_step(scene);
  settings.gravity = {{0.0, -scene.gravity}};
  settings.gravity_ramp = gravity_ramp;
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  settings.spring = {stiffness(scene), damping(scene)};
  settings.slip_drag = slip_drag(scene);
  settings.static_friction = static_friction(scene);
  settings.well_width = well_width;
  // Without gravity, that in which a grain presses 1e-4 d into a contact takes its place.
  constexpr double usual_overlap = 1e-4;
  const double gravity = scene.gravity > 0.0 ? scene.gravity : usual_overlap * d * stiffness(scene) / mass;
  constexpr double slow = 1e-3;
  settings.slow = slow * std::sqrt(gravity * d);
  settings.weight = mass * gravity;
  settings.tolerance = tolerance;
  settings.by_sweeps = algorithm == "sweeps";
  settings.relaxation = relaxation;
  settings.pinned_base = pin_base.value_or(false);
  settings.relaxed_start = relax.value_or(false);
  settings.skin = skin;
  return std::make_unique<Hybrid>(scene.impulse_laws(), settings);
}

}  // namespace repose
