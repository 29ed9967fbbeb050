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

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The interval [T] between two checks.
double interval_of(const Scene& scene) {
  if (scene.gravity > 0.0) return 0.5 * std::sqrt(scene.grains.diameter / scene.gravity);
  return 0.05 * scene.output.window;
}

/// The solver of rigid grains leaves net forces of this many times its tolerance.
constexpr double forces_of_tolerance = 10.0;

double limit_of_forces(const Scene& scene) {
  const auto* solver = scene.method->solver();
  const double of_solver = solver != nullptr ? forces_of_tolerance * solver->tolerance : 0.0;
  return std::max(*scene.stop.at_rest, of_solver);
}

}  // namespace

template <int D>
Unrest largest_unrest(const Grains<D>& grains, const Contacts<D>& contacts, const std::vector<Load<D>>& loads,
                      const Vec<D>& gravity_vector, double diameter) {
  const double gravity = magnitude(gravity_vector);
  auto net = net_forces(grains, contacts, gravity_vector);
  for (const auto& load : loads) {
    const auto found = std::find(grains.id.begin(), grains.id.end(), load.grain);
    if (found != grains.id.end()) net[static_cast<std::size_t>(found - grains.id.begin())] += load.force;
  }
  const double mean = gravity > 0.0 ? 0.0 : mean_normal_force(contacts);
  Unrest largest;
  const auto take = [](double& so_far, double value) {
    so_far = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(so_far, value);
  };
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (grain.fixed()) continue;
    const double speed2 = squared(grain.velocity) + squared(grain.rim_velocity) / inverse_inertia_factor<D>;
    const double weight = gravity > 0.0 ? grain.mass * gravity : mean;
    take(largest.kinetic_energy, weight > 0.0 ? 0.5 * grain.mass * speed2 / (weight * diameter) : infinite);
    take(largest.net_force, weight > 0.0 ? magnitude(net[k]) / weight : infinite);
  }
  return largest;
}

template Unrest largest_unrest(const Grains<2>&, const Contacts<2>&, const std::vector<Load<2>>&, const Vec<2>&,
                               double);
template Unrest largest_unrest(const Grains<3>&, const Contacts<3>&, const std::vector<Load<3>>&, const Vec<3>&,
                               double);

Rest::Rest(const Scene& scene, const TimeSteps& steps) : times_(0.0, steps) {
  if (!scene.stop.at_rest) return;
  times_ = Every(interval_of(scene), steps);
  limit_ = *scene.stop.at_rest;
  force_limit_ = limit_of_forces(scene);
  window_ = scene.output.window;
  with_dimension(scene.dimension, [&](auto dimension) {
    for (const auto& wall : make_walls<dimension>(scene)) {
      if (std::isfinite(wall.opens_at)) not_before_ = std::max(not_before_, wall.opens_at);
      if (wall.motion.kind == WallMotion<dimension>::Kind::none) continue;
      not_before_ = std::max(not_before_, std::isfinite(wall.motion.stop) ? wall.motion.stop : wall.motion.start);
    }
  });
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
