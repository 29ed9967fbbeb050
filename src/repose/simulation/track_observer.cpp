// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/track_observer.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/simulation.hpp"

namespace repose {

void TrackObserver::observe(const Simulation& simulation) {
  if (!track_.empty() && track_.back().time == simulation.time()) return;
  const auto& grains = simulation.grains();
  const auto box = make_box(simulation.scene());
  const auto in_heap = supported(grains, simulation.contacts());
  TrackMoment moment{simulation.time(), {}};
  moment.grains.reserve(simulation.moving());
  for (const auto k : by_id(grains)) {
    const auto& grain = grains.line[k];
    if (grain.fixed() || box.outside(grain.position)) continue;
    const auto place = box.wrapped(grain.position);
    moment.grains.push_back({grains.id[k], static_cast<float>(place[0]), static_cast<float>(place[1]),
                             static_cast<float>(grain.radius), static_cast<float>(kinetic_energy(grain)), in_heap[k]});
  }
  track_.push_back(std::move(moment));
}

}  // namespace repose
