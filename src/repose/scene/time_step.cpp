// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/time_step.hpp"

#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const auto& source = scene.source;
  const auto& start = scene.start;
  const auto rise = [&](const std::array<double, 2>& velocity) {
    return scene.gravity > 0.0 ? 0.5 * (std::pow(velocity[0], 2) + std::pow(velocity[1], 2)) / scene.gravity : 0.0;
  };
  double fall = std::max(scene.grains.diameter, start.fall);
  if (source.drops()) fall = std::max(start.fall, source.height + rise(source.velocity));
  if (source.kind == "lattice") {
    const double pitch = source.columns > 0 ? scene.block_pitch() : scene.grains.diameter;
    fall = std::max(start.fall, static_cast<double>(source.rows) * pitch);
  }
  for (const auto& grain : scene.placed) fall = std::max(fall, rise(grain.velocity) + std::max(0.0, grain.position[1]));
  return fall;
}

}  // namespace

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
  for (const auto& grain : placed) fastest = std::max(fastest, std::hypot(grain.velocity[0], grain.velocity[1]));
  return fastest;
}

namespace {

/// Of rigid grains: only g dt^2 over a radius matters while they rest and roll, and in flight the way of a step.
constexpr double rigid_fall = 0.1;
constexpr double rigid_way = 0.5;

double rigid_step(const Scene& scene) {
  const double radius = 0.5 * scene.smallest_diameter();
  const double of_fall =
      scene.gravity > 0.0 ? std::sqrt(rigid_fall * radius / scene.gravity) : std::numeric_limits<double>::infinity();
  const auto limit = scene.method.speed_limit;
  // A sequential source lets no grain become faster than g dt.
  if (!limit && scene.source.kind == "sequential") return of_fall;
  const double speed = limit ? std::min(*limit, scene.fastest_fall()) : scene.fastest_fall();
  return std::min(of_fall, rigid_way * radius / speed);
}

}  // namespace

std::optional<double> Scene::speed_limit() const {
  if (method.speed_limit || source.kind != "sequential") return method.speed_limit;
  return gravity * time_step();
}

double Scene::automatic_step() const {
  if (method.rigid()) return rigid_step(*this);
  return std::min(auto_phase / contact_frequency(), auto_part_of_bed * largest_step_of_bed());
}

double Scene::time_step() const {
  if (method.deposits()) return 1.0;  // time counts discs
  return method.time_step ? *method.time_step : automatic_step();
}

}  // namespace repose
