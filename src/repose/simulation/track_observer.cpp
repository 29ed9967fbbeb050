// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/track_observer.hpp"

#include "repose/analysis/heap.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/simulation.hpp"

namespace repose {

template <int D>
void TrackObserver<D>::observe(const Simulation<D>& simulation) {
  if (!track_.empty() && track_.back().time == simulation.time()) return;
  const auto& grains = simulation.grains();
  const auto box = make_box<D>(simulation.scene());
  const auto in_heap = supported(grains, simulation.contacts());
  TrackMoment<D> moment{simulation.time(), {}};
  moment.grains.reserve(simulation.moving());
  for (const auto k : by_id(grains)) {
    const auto& grain = grains.line[k];
    if (grain.fixed() || box.outside(grain.position)) continue;
    const auto place = box.wrapped(grain.position);
    TrackedGrain<D> tracked{
        grains.id[k], {}, static_cast<float>(grain.radius), static_cast<float>(kinetic_energy(grain)), in_heap[k]};
    for (int axis = 0; axis < D; ++axis) {
      tracked.position[static_cast<std::size_t>(axis)] = static_cast<float>(place[axis]);
    }
    moment.grains.push_back(tracked);
  }
  track_.push_back(std::move(moment));
}

template class TrackObserver<2>;
template class TrackObserver<3>;

}  // namespace repose
