// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/rest.hpp"

#include "repose/analysis/force_network.hpp"
#include "repose/scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

/// The interval between two checks, over sqrt(d/g).
constexpr double interval = 0.5;

/// The solver of rigid grains leaves net forces of this many times its tolerance.
constexpr double forces_of_tolerance = 10.0;

double limit_of_forces(const Scene& scene) {
  const auto* solver = scene.method->solver();
  const double of_solver = solver != nullptr ? forces_of_tolerance * solver->tolerance : 0.0;
  return std::max(*scene.stop.at_rest, of_solver);
}

}  // namespace

Unrest largest_unrest(const Grains<2>& grains, const Contacts<2>& contacts, const std::vector<Load<2>>& loads,
                      double gravity, double diameter) {
  auto net = net_forces(grains, contacts, Vec<2>{{0.0, -gravity}});
  for (const auto& load : loads) {
    const auto found = std::find(grains.id.begin(), grains.id.end(), load.grain);
    if (found != grains.id.end()) net[static_cast<std::size_t>(found - grains.id.begin())] += load.force;
  }
  Unrest largest;
  const auto take = [](double& so_far, double value) {
    so_far = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(so_far, value);
  };
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (grain.fixed()) continue;
    const double speed2 = squared(grain.velocity) + squared(grain.rim_velocity) / inverse_inertia_factor<2>;
    take(largest.kinetic_energy, 0.5 * speed2 / (gravity * diameter));
    take(largest.net_force, magnitude(net[k]) / (grain.mass * gravity));
  }
  return largest;
}

Rest::Rest(const Scene& scene, const TimeSteps& steps) : times_(0.0, steps) {
  if (!scene.stop.at_rest || !(scene.gravity > 0.0)) return;
  times_ = Every(interval * std::sqrt(scene.grains.diameter / scene.gravity), steps);
  limit_ = *scene.stop.at_rest;
  force_limit_ = limit_of_forces(scene);
  window_ = scene.output.window;
  for (const auto& wall : make_walls(scene)) {
    if (std::isfinite(wall.opens_at)) not_before_ = std::max(not_before_, wall.opens_at);
    if (wall.motion.kind == WallMotion<2>::Kind::none) continue;
    not_before_ = std::max(not_before_, std::isfinite(wall.motion.stop) ? wall.motion.stop : wall.motion.start);
  }
}

bool Rest::lasts(const Unrest& unrest, double time) {
  if (time <= not_before_ || !(unrest.kinetic_energy < limit_ && unrest.net_force < force_limit_)) {
    since_ = never;
    return false;
  }
  since_ = std::min(since_, time);
  return time - since_ >= window_ * (1.0 - 1e-9);
}

}  // namespace repose
