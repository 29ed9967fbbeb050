// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

#include "repose/laws/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  if (base.kind == "row") smallest = std::min(smallest, grains.diameter);
  if (start.largest > 0.0) smallest = std::min(smallest, start.smallest);
  for (const auto& grain : placed) smallest = std::min(smallest, grain.diameter);
  return smallest;
}

double Scene::largest_diameter() const {
  double largest = std::max(largest_drawn(), start.largest);
  if (base.kind == "row") largest = std::max(largest, grains.diameter);
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
  return density * grains.mass * std::pow(diameter / grains.diameter, 2);
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

}  // namespace

double Scene::contact_frequency() const {
  const auto rise = [&](const std::array<double, 2>& velocity) {
    return gravity > 0.0 ? 0.5 * (std::pow(velocity[0], 2) + std::pow(velocity[1], 2)) / gravity : 0.0;
  };
  double fall = std::max(grains.diameter, start.fall);
  if (source.drops()) fall = std::max(start.fall, source.height + rise(source.velocity));
  if (source.kind == "lattice") {
    const double pitch = source.columns > 0 ? block_pitch() : grains.diameter;
    fall = std::max(start.fall, static_cast<double>(source.rows) * pitch);
  }
  for (const auto& grain : placed) fall = std::max(fall, rise(grain.velocity) + std::max(0.0, grain.position[1]));
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

double Scene::automatic_step() const {
  return std::min(auto_phase / contact_frequency(), auto_part_of_bed * largest_step_of_bed());
}

double Scene::time_step() const {
  if (method.deposits()) return 1.0;  // time counts discs
  return method.time_step ? *method.time_step : automatic_step();
}

}  // namespace repose
