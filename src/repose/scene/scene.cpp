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
  return std::max(1.0, std::sqrt(static_cast<double>(source.count) * 0.9 / std::sqrt(3.0)));
}

double Scene::contact_frequency() const {
  double fall = source.kind == "pour" ? source.height : grains.diameter;
  if (source.kind == "lattice") fall = static_cast<double>(source.rows) * grains.diameter;
  for (const auto& grain : placed) {
    const double speed2 = std::pow(grain.velocity[0], 2) + std::pow(grain.velocity[1], 2);
    const double rise = gravity > 0.0 ? 0.5 * speed2 / gravity : 0.0;
    fall = std::max(fall, rise + std::max(0.0, grain.position[1]));
  }
  const auto names = material_names();
  const auto laws = material_laws();
  double frequency = 0.0;
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = 0; b < names.size(); ++b) {
      for (const double mover : {smallest_diameter(), largest_diameter()}) {
        for (const double partner : {smallest_diameter(), grains.diameter, largest_diameter()}) {
          const auto stiffest = stiffest_contact(laws.table[a * names.size() + b], {mover, mass_of(mover, names[a])},
                                                 {partner, mass_of(partner, names[b])}, gravity, fall);
          frequency = std::max(frequency, stiffest.frequency);
        }
      }
    }
  }
  return frequency;
}

double Scene::time_step() const { return method.time_step ? *method.time_step : auto_phase / contact_frequency(); }

}  // namespace repose
