// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// What time steps are judged by: how fast grains fall, and the contacts that they can make.

namespace repose {

namespace {

/// The contacts between all materials and the sizes at the ends of their range: laws, who moves, and its partner.
template <class Use>
void for_every_contact(const Scene& scene, const Use& use) {
  const auto names = scene.material_names();
  const auto laws = scene.material_laws();
  const auto size = [&](double diameter, const std::string& material) {
    return GrainSize{diameter, scene.mass_of(diameter, material)};
  };
  const double sizes[] = {scene.smallest_diameter(), scene.grains.diameter, scene.largest_diameter()};
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = 0; b < names.size(); ++b) {
      for (const double mover : {sizes[0], sizes[2]}) {
        for (const double partner : sizes) {
          use(laws.table[a * names.size() + b], size(mover, names[a]), size(partner, names[b]));
        }
      }
    }
  }
}

/// Height from which the fastest grain seems to fall [L].
double highest_fall(const Scene& scene) {
  double fall = std::max(scene.start.fall, scene.source->fall(scene));
  for (const auto& grain : scene.placed) {
    fall = std::max(fall, scene.rise(grain.velocity) + std::max(0.0, grain.position[1]));
  }
  return fall;
}

}  // namespace

double Scene::rise(const std::array<double, 2>& velocity) const {
  return gravity > 0.0 ? 0.5 * (velocity[0] * velocity[0] + velocity[1] * velocity[1]) / gravity : 0.0;
}

double Scene::contact_frequency() const {
  const double fall = highest_fall(*this);
  double frequency = 0.0;
  for_every_contact(*this, [&](const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner) {
    frequency = std::max(frequency, stiffest_contact(laws, mover, partner, gravity, fall).frequency);
  });
  return frequency;
}

double Scene::largest_step_of_bed() const {
  const double force = expected_column() * grain_weight();
  double step = std::numeric_limits<double>::infinity();
  for_every_contact(*this, [&](const ContactLaws& laws, const GrainSize& mover, const GrainSize& partner) {
    step = std::min(step, repose::largest_step_of_bed(laws, mover, partner, force));
  });
  return step;
}

double Scene::fastest_fall() const {
  // Without gravity nothing falls, but what is placed flies.
  if (gravity > 0.0) return std::sqrt(2.0 * gravity * highest_fall(*this));
  double fastest = 0.0;
  for (const auto& grain : placed)
    fastest = std::max(fastest, reproducible::hypot(grain.velocity[0], grain.velocity[1]));
  return fastest;
}

}  // namespace repose
