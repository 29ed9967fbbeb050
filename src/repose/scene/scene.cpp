// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/laws/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace repose {

double Scene::base_pitch() const {
  return base.kind == "row" ? std::max(base.spacing, grains.diameter) : grains.diameter;
}

bool Scene::block_nests() const {
  return base.kind == "row" && source.gap == 0.0 && smallest_drawn() == grains.diameter &&
         largest_drawn() == grains.diameter;
}

double Scene::block_pitch() const { return block_nests() ? base_pitch() : largest_drawn() + source.gap; }

double Scene::smallest_drawn() const {
  double smallest = grains.diameter * (1.0 - grains.polydispersity);
  if (!species.empty()) smallest = species.front().sizes.smallest();
  for (const auto& one : species) smallest = std::min(smallest, one.sizes.smallest());
  return smallest;
}

double Scene::largest_drawn() const {
  double largest = grains.diameter;
  if (!species.empty()) largest = species.front().sizes.largest();
  for (const auto& one : species) largest = std::max(largest, one.sizes.largest());
  return largest;
}

double Scene::smallest_diameter() const {
  double smallest = smallest_drawn();
  if (base.kind == "row" || base.kind == "contiguous") smallest = std::min(smallest, grains.diameter);
  if (start.largest > 0.0) smallest = std::min(smallest, start.smallest);
  for (const auto& grain : placed) smallest = std::min(smallest, grain.diameter);
  return smallest;
}

double Scene::largest_diameter() const {
  double largest = std::max(largest_drawn(), start.largest);
  if (base.kind == "row" || base.kind == "contiguous") largest = std::max(largest, grains.diameter);
  for (const auto& grain : placed) largest = std::max(largest, grain.diameter);
  return largest;
}

bool Scene::synchronised() const {
  if (method.velocities != "auto") return method.velocities == "synchronised";
  return largest_diameter() / smallest_diameter() > synchronised_above_ratio;
}

std::vector<std::string> Scene::material_names() const {
  std::vector<std::string> names;
  for (const auto& material : materials) {
    names.push_back(material.name.empty() ? "material " + std::to_string(names.size()) : material.name);
  }
  if (names.empty()) names.emplace_back("grain");
  return names;
}

std::uint16_t Scene::material_number(const std::string& name) const {
  const auto names = material_names();
  const auto found = std::find(names.begin(), names.end(), name);
  return static_cast<std::uint16_t>(found == names.end() ? 0 : found - names.begin());
}

double Scene::mass_of(double diameter, const std::string& material) const {
  const double density = materials.empty() ? 1.0 : materials[material_number(material)].density;
  const double size = diameter / grains.diameter;
  return density * grains.mass * (size * size);
}

MaterialLaws Scene::material_laws() const {
  const auto count = material_names().size();
  MaterialLaws laws{count, std::vector<ContactLaws>(count * count, contact.laws())};
  for (const auto& pair : pairs) {
    const auto a = material_number(pair.first);
    const auto b = material_number(pair.second);
    laws.table[a * count + b] = laws.table[b * count + a] = pair.contact.laws();
  }
  return laws;
}

ImpulseLaws Scene::impulse_laws() const {
  const auto count = material_names().size();
  std::vector<ImpulseLaw> table(count * count, contact.impulse);
  for (const auto& pair : pairs) {
    const auto a = material_number(pair.first);
    const auto b = material_number(pair.second);
    table[a * count + b] = table[b * count + a] = pair.contact.impulse;
  }
  return {std::move(table), count};
}

double Scene::expected_column() const {
  if (source.kind == "lattice") return static_cast<double>(source.rows);
  // N grains in a triangle of height h and slope 30 degrees: N = h^2 sqrt(3) / 0.9 (a core of discs at 0.8).
  return std::max(1.0, std::sqrt(static_cast<double>(source.count + start.moving) * 0.9 / std::sqrt(3.0)));
}

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
    return scene.gravity > 0.0 ? 0.5 * (velocity[0] * velocity[0] + velocity[1] * velocity[1]) / scene.gravity : 0.0;
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
  for (const auto& grain : placed)
    fastest = std::max(fastest, reproducible::hypot(grain.velocity[0], grain.velocity[1]));
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
