// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/deposition/deposition.hpp"

#include "repose/core/random.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/deposition.hpp"
#include "repose/simulation/sources/draw.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace repose {

std::unique_ptr<Method<2>> DepositionMethod::make(const Scene& scene) const {
  DepositionSettings settings;
  settings.critical_angle_deg = critical_angle;
  settings.box = make_box(scene);
  settings.floor = -0.5 * scene.grains.diameter;
  settings.smallest_radius = 0.5 * std::min(scene.smallest_drawn(), scene.grains.diameter);
  settings.largest_radius = 0.5 * std::max(scene.largest_drawn(), scene.grains.diameter);
  settings.snapped = snaps();
  settings.count = scene.source->released();
  settings.draw = [seed = static_cast<std::uint64_t>(scene.seed),
                   draw = GrainDraw(scene, Purpose::grain_species, Purpose::grain_size)](std::int64_t k,
                                                                                         std::span<DroppedDisc> discs) {
    for (auto& disc : discs) {
      const auto index = static_cast<std::uint64_t>(k++);
      const auto [grain, material] = draw(index);
      disc = {uniform(seed, Purpose::release_position, index), grain.radius, grain.mass, material};
    }
  };
  return make_deposition(settings);
}

}  // namespace repose
