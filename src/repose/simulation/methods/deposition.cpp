// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/deposition.hpp"

#include "repose/core/random.hpp"
#include "repose/methods/deposition/spheres.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/deposition.hpp"
#include "repose/scene/sources/at_start.hpp"
#include "repose/simulation/sources/draw.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

namespace repose {

std::unique_ptr<Method<2>> DepositionMethod::make(const Scene& scene, Dimension<2>) const {
  DepositionSettings settings;
  settings.critical_angle_deg = critical_angle;
  settings.box = make_box(scene);
  settings.floor = -0.5 * scene.grains.diameter;
  settings.smallest_radius = 0.5 * std::min(scene.smallest_drawn(), scene.grains.diameter);
  settings.largest_radius = 0.5 * std::max(scene.largest_drawn(), scene.grains.diameter);
  settings.snapped = snaps();
  settings.count = scene.source->released();
  settings.draw = [seed = static_cast<std::uint64_t>(scene.seed),
                   draw = GrainDraw<2>(scene, Purpose::grain_species, Purpose::grain_size)](
                      std::int64_t k, std::span<DroppedDisc> discs) {
    for (auto& disc : discs) {
      const auto index = static_cast<std::uint64_t>(k++);
      const auto [grain, material] = draw(index);
      disc = {uniform(seed, Purpose::release_position, index), grain.radius, grain.mass, material};
    }
  };
  return make_deposition(settings);
}

std::unique_ptr<Method<3>> DepositionMethod::make(const Scene& scene, Dimension<3>) const {
  SphereDepositionSettings settings;
  settings.critical_angle_deg = critical_angle;
  settings.box = make_box<3>(scene);
  if (scene.box.open()) {
    // An open base: what falls beside it is lost.
    settings.box.x_max = settings.box.y_max = std::numeric_limits<double>::infinity();
    settings.box.x_min = settings.box.y_min = -settings.box.x_max;
  }
  // In a closed box a sphere that slips through the base comes to rest below it.
  if (!scene.base->of_grains()) {
    settings.floor = 0.0;
  } else if (!scene.box.open()) {
    settings.floor = -0.5 * scene.grains.diameter;
  }
  settings.snapped = snaps();
  const auto& source = *scene.source.as<DepositedSpheres>();
  if (source.radius) settings.drop_radius = *source.radius;
  settings.largest_radius = 0.5 * std::max(scene.largest_drawn(), scene.grains.diameter);
  settings.count = source.released();
  settings.draw = [seed = static_cast<std::uint64_t>(scene.seed),
                   draw = GrainDraw<3>(scene, Purpose::grain_species, Purpose::grain_size)](
                      std::int64_t k, std::span<DroppedSphere> spheres) {
    for (auto& sphere : spheres) {
      const auto index = static_cast<std::uint64_t>(k++);
      const auto [grain, material] = draw(index);
      const auto random = [&](std::uint32_t number) { return uniform(seed, Purpose::release_position, index, number); };
      sphere = {{random(0), random(1)}, grain.radius, grain.mass, material};
    }
  };
  return make_sphere_deposition(settings);
}

}  // namespace repose
