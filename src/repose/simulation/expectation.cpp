// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/expectation.hpp"

#include "repose/record/record.hpp"
#include "repose/scene/geometry.hpp"
#include "repose/simulation/series.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <algorithm>

namespace repose {

namespace {

struct GrainCount {
  double all = 0.0;
  double moving = 0.0;
};

GrainCount grains_at_start(const Scene& scene) {
  const auto expected = static_cast<double>(scene.start.moving);
  if (scene.start.expected) return {expected, expected};
  return with_dimension(scene.dimension, [&](auto dimension) {
    const auto grains = initial_grains<dimension>(scene);
    return GrainCount{static_cast<double>(grains.size()), static_cast<double>(moving_count(grains))};
  });
}

}  // namespace

double expected_end(const Scene& scene) {
  if (scene.stop.time && !scene.stop.at_rest) return *scene.stop.time;
  const double end = scene.source->expected_end(scene);
  return scene.stop.time ? std::min(end, *scene.stop.time) : end;
}

double expected_work(const Scene& scene, double time) {
  return (grains_at_start(scene).moving * time + scene.source->expected_work(scene, time)) / scene.time_step();
}

double expected_speed(const Scene& scene) {
  return scene.method->traits().typical_speed / (scene.dimension == 3 ? 4.0 : 1.0);
}

double expected_memory(const Scene& scene) {
  constexpr double of_program = 5e7;
  constexpr double of_grain = 2000.0;
  constexpr double copies = 2.0;  // the record of a run is one
  constexpr double day = 86400.0;
  const auto traits = scene.method->traits();
  const double grains = grains_at_start(scene).all + static_cast<double>(scene.source->released());
  double memory = of_program + of_grain * grains;
  if (!traits.follows_time) return memory;
  const double end = expected_end(scene);
  const double seconds = expected_work(scene, end) / expected_speed(scene);
  const double reached = end * std::min(1.0, day / std::max(seconds, 1.0));
  const auto times = [&](double interval) {
    return interval > 0.0 ? reached / std::max(interval, scene.time_step()) : 0.0;
  };
  const auto walls = static_cast<double>(wall_names(scene).size());
  const auto slices = static_cast<double>(followed_slices(scene));
  memory += copies * times(scene.output.series) *
            (sizeof(SeriesRow) + walls * sizeof(WallRow<3>) + slices * sizeof(ColumnSlice));
  memory += copies * times(scene.output.track) * grains * sizeof(TrackedGrain<3>);
  return memory;
}

}  // namespace repose
