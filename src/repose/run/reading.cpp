// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/reading.hpp"

namespace repose {

Reading read(const Simulation& simulation, const Contacts<2>& contacts) {
  const auto& scene = simulation.scene();
  const auto grains = simulation.wrapped_grains();
  Reading reading;
  const auto in_heap = supported(grains, contacts);
  reading.heap = read_heap(grains, in_heap, reading.base_height, scene.analysis.bin_width);
  reading.network =
      read_force_network(grains, contacts, in_heap, scene.analysis.force_threshold * scene.grain_weight());
  reading.base = simulation.base_profile();
  reading.dip = base_dip(reading.base);
  double weight = 0.0;
  for (const auto k : by_id(grains)) {
    if (in_heap[k]) weight += grains.line[k].mass * scene.gravity;
  }
  if (weight > 0.0) reading.weight_error = simulation.force_on_supports(contacts) / weight - 1.0;
  return reading;
}

}  // namespace repose
