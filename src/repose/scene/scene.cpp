// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

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

}  // namespace repose
