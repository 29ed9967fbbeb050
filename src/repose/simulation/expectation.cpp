// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/expectation.hpp"

#include "repose/simulation/sources/initial.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

double expected_end(const Scene& scene) {
  if (scene.method.deposits()) return static_cast<double>(scene.source.count);
  if (scene.stop.time && !scene.stop.at_rest) return *scene.stop.time;
  double end = 100.0 * std::sqrt(scene.grains.diameter / std::max(scene.gravity, 1e-30));
  if (scene.source.kind == "sequential") {
    constexpr double steps_of_a_grain = 20.0;  // until it lies still; seen in examples/deposition-cd.toml
    end = steps_of_a_grain * scene.time_step() * static_cast<double>(scene.source.count);
  }
  if (scene.source.drops()) {
    end = static_cast<double>(scene.source.count) / scene.source.rate +
          std::sqrt(2.0 * scene.source.height / scene.gravity) +
          50.0 * std::sqrt(scene.grains.diameter / scene.gravity);
  }
  return scene.stop.time ? std::min(end, *scene.stop.time) : end;
}

double expected_work(const Scene& scene, double time) {
  if (scene.method.deposits()) return time;  // one disc a step
  double work = static_cast<double>(moving_count(initial_grains(scene))) * time;
  if (scene.source.drops()) {
    const double pouring = static_cast<double>(scene.source.count) / scene.source.rate;
    const double during = std::min(time, pouring);
    work += 0.5 * scene.source.rate * during * during + static_cast<double>(scene.source.count) * (time - during);
  }
  if (scene.source.kind == "sequential") work += 0.5 * static_cast<double>(scene.source.count) * time;
  return work / scene.time_step();
}

}  // namespace repose
