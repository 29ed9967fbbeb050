// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

#include "repose/laws/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

double Scene::base_pitch() const {
  return base.kind == "row" ? std::max(base.spacing, grains.diameter) : grains.diameter;
}

double Scene::smallest_diameter() const {
  double smallest = grains.diameter * (1.0 - grains.polydispersity);
  for (const auto& grain : placed) smallest = std::min(smallest, grain.diameter);
  return smallest;
}

double Scene::largest_diameter() const {
  double largest = grains.diameter;
  for (const auto& grain : placed) largest = std::max(largest, grain.diameter);
  return largest;
}

bool Scene::synchronised() const {
  if (method.velocities != "auto") return method.velocities == "synchronised";
  return largest_diameter() / smallest_diameter() > synchronised_above_ratio;
}

double Scene::contact_frequency() const {
  double fall = source.kind == "pour" ? source.height : grains.diameter;
  if (source.kind == "lattice") fall = static_cast<double>(source.rows) * grains.diameter;
  for (const auto& grain : placed) {
    const double speed2 = std::pow(grain.velocity[0], 2) + std::pow(grain.velocity[1], 2);
    const double rise = gravity > 0.0 ? 0.5 * speed2 / gravity : 0.0;
    fall = std::max(fall, rise + std::max(0.0, grain.position[1]));
  }
  const ContactConditions conditions{.smallest_diameter = smallest_diameter(),
                                     .largest_diameter = largest_diameter(),
                                     .diameter = grains.diameter,
                                     .mass = grains.mass,
                                     .gravity = gravity,
                                     .fall = fall};
  return stiffest_contact(contact.normal, contact.tangential, conditions).frequency;
}

double Scene::time_step() const { return method.time_step ? *method.time_step : auto_phase / contact_frequency(); }

}  // namespace repose
