// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/rest.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

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
  std::unordered_map<std::int64_t, std::size_t> place;
  place.reserve(grains.size());
  std::vector<Vec<2>> net(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    place.emplace(grains.id[k], k);
    net[k] = Vec<2>{{0.0, -gravity * grains.line[k].mass}};
  }
  for (const auto& contact : contacts.list) {
    const Vec<2> force = force_of(contact);
    net[place.at(contact.first)] += force;
    if (contact.second >= 0) net[place.at(contact.second)] -= force;
  }
  for (const auto& load : loads) {
    if (const auto found = place.find(load.grain); found != place.end()) net[found->second] += load.force;
  }
  Unrest largest;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    if (grain.fixed()) continue;
    const double energy = 0.5 * (squared(grain.velocity) + squared(grain.rim_velocity) / inverse_inertia_factor<2>) /
                          (gravity * diameter);
    const double force = magnitude(net[k]) / (grain.mass * gravity);
    // A number that is not one is no rest.
    if (!(energy <= largest.kinetic_energy)) largest.kinetic_energy = energy;
    if (!(force <= largest.net_force)) largest.net_force = force;
  }
  return largest;
}

Rest::Rest(const Scene& scene, const TimeSteps& steps) : times_(0.0, steps) {
  if (!scene.stop.at_rest || !(scene.gravity > 0.0)) return;
  times_ = Every(interval * std::sqrt(scene.grains.diameter / scene.gravity), steps);
  limit_ = *scene.stop.at_rest;
  force_limit_ = limit_of_forces(scene);
  window_ = scene.output.window;
}

bool Rest::lasts(const Unrest& unrest, double time) {
  if (!(unrest.kinetic_energy < limit_ && unrest.net_force < force_limit_)) {
    since_ = never;
    return false;
  }
  since_ = std::min(since_, time);
  return time - since_ >= window_ * (1.0 - 1e-9);
}

}  // namespace repose
