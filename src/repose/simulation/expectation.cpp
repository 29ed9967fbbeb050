// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/expectation.hpp"

#include "repose/simulation/sources/initial.hpp"

#include <algorithm>

namespace repose {

double expected_end(const Scene& scene) {
  if (scene.stop.time && !scene.stop.at_rest) return *scene.stop.time;
  const double end = scene.source->expected_end(scene);
  return scene.stop.time ? std::min(end, *scene.stop.time) : end;
}

double expected_work(const Scene& scene, double time) {
  const auto at_start = static_cast<double>(moving_count(initial_grains(scene))) * time;
  return (at_start + scene.source->expected_work(scene, time)) / scene.time_step();
}

}  // namespace repose
