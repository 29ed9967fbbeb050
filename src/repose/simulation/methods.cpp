// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/methods.hpp"

#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"
#include "repose/methods/deposition/deposition.hpp"
#include "repose/methods/soft/soft.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/sources/draw.hpp"

#include <algorithm>

namespace repose {

namespace {

std::unique_ptr<Method<2>> make_deposition_of(const Scene& scene) {
  DepositionSettings settings;
  settings.critical_angle_deg = scene.method.critical_angle;
  settings.box = make_box(scene);
  settings.floor = -0.5 * scene.grains.diameter;
  settings.smallest_radius = 0.5 * std::min(scene.smallest_drawn(), scene.grains.diameter);
  settings.largest_radius = 0.5 * std::max(scene.largest_drawn(), scene.grains.diameter);
  settings.snapped = scene.snapped();
  settings.count = scene.source.count;
  settings.drop = [seed = static_cast<std::uint64_t>(scene.seed),
                   draw = GrainDraw(scene, Purpose::grain_species, Purpose::grain_size)](std::int64_t k) {
    const auto index = static_cast<std::uint64_t>(k);
    const auto [grain, material] = draw(index);
    return DroppedDisc{uniform(seed, Purpose::release_position, index), grain, material};
  };
  return make_deposition(settings);
}

std::unique_ptr<Method<2>> make_contact_dynamics_of(const Scene& scene) {
  ContactDynamicsSettings<2> settings;
  settings.time_step = scene.time_step();
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  if (const auto limit = scene.speed_limit()) settings.speed_limit = *limit;
  settings.solver.tolerance = scene.method.tolerance;
  settings.solver.most_sweeps = scene.method.most_sweeps;
  settings.solver.accelerated = scene.method.solver == "accelerated";
  settings.overlap_recovery = scene.method.overlap_recovery;
  settings.skin = scene.method.skin;
  return make_contact_dynamics<2>(scene.impulse_laws(), settings);
}

}  // namespace

std::unique_ptr<Method<2>> make_method(const Scene& scene) {
  if (scene.method.deposits()) return make_deposition_of(scene);
  if (scene.method.rigid()) return make_contact_dynamics_of(scene);
  SoftSettings<2> settings;
  settings.time_step = scene.time_step();
  settings.gravity = {{0.0, -scene.gravity}};
  settings.box = make_box(scene);
  settings.walls = make_walls(scene);
  settings.synchronised = scene.synchronised();
  settings.audit = scene.output.energy;
  settings.skin = scene.method.skin;
  return make_soft<2>(scene.material_laws(), settings);
}

}  // namespace repose
