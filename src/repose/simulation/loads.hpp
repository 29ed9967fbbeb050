// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/methods/method.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace repose {

/// The loads of a scene: each acts on one grain from its start on.
template <int D = 2>
class Loads {
 public:
  Loads(const Scene& scene, const TimeSteps& steps);

  /// Time [T] at which the next load begins; infinity once all have begun.
  double due() const;

  /// Begins the loads that are due at a time, each on the grain that is then nearest to its place unless the scene
  /// names a grain; true if any was due.
  bool begin_due(double time, const Grains<D>& grains);

  const std::vector<Load<D>>& acting() const { return acting_; }

  void exchange(Archive& archive);

 private:
  std::int64_t nearest_grain(const Vec<D>& place, const Grains<D>& grains) const;

  Box<D> box_;
  TimeSteps steps_;
  std::vector<Scene::Load> by_start_;
  std::size_t begun_ = 0;
  std::vector<Load<D>> acting_;
};

/// Throws InputError for each load of the scene on a grain that never exists or is fixed. `at_start` are the grains at
/// the start.
template <int D>
void check_loads_on(const Grains<D>& at_start, const Scene& scene);

}  // namespace repose
