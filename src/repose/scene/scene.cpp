// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace repose {

namespace {

/// Two materials of the scene by number, and what is special between them.
template <class Laws>
std::vector<Laws> table_of(const Scene& scene, const Laws& usual, Laws (*of_pair)(const MaterialContact&)) {
  const auto count = scene.material_names().size();
  std::vector<Laws> table(count * count, usual);
  for (const auto& pair : scene.pairs) {
    const auto a = scene.material_number(pair.first);
    const auto b = scene.material_number(pair.second);
    table[a * count + b] = table[b * count + a] = of_pair(pair.contact);
  }
  return table;
}

/// Sets what follows from the elastic constants of the two materials.
void set_moduli(ContactLaws& laws, const Elasticity& a, const Elasticity& b) {
  if (auto* normal = std::get_if<ElasticHertz>(&laws.normal)) normal->modulus = effective_modulus(a, b);
  if (auto* tangential = std::get_if<Mindlin>(&laws.tangential)) tangential->ratio = stiffness_ratio(a, b);
}

/// Adhesion has the modulus of Hertz's law.
void set_adhesion(ContactLaws& laws) {
  auto* adhesion = std::get_if<Jkr>(&laws.cohesion);
  if (adhesion == nullptr) return;
  if (const auto* elastic = std::get_if<ElasticHertz>(&laws.normal)) adhesion->modulus = elastic->modulus;
  if (const auto* plain = std::get_if<Hertz>(&laws.normal)) adhesion->stiffness = plain->stiffness;
}

}  // namespace

double Scene::smallest_drawn() const {
  double smallest = grains.diameter * (1.0 - grains.polydispersity);
  if (!species.empty()) smallest = species.front().sizes->smallest();
  for (const auto& one : species) smallest = std::min(smallest, one.sizes->smallest());
  return smallest;
}

double Scene::largest_drawn() const {
  double largest = grains.diameter;
  if (!species.empty()) largest = species.front().sizes->largest();
  for (const auto& one : species) largest = std::max(largest, one.sizes->largest());
  return largest;
}

double Scene::smallest_diameter() const {
  double smallest = smallest_drawn();
  if (base->of_one_size()) smallest = std::min(smallest, grains.diameter);
  if (start.largest > 0.0) smallest = std::min(smallest, start.smallest);
  for (const auto& grain : placed) smallest = std::min(smallest, grain.diameter);
  return smallest;
}

double Scene::largest_diameter() const {
  double largest = std::max(largest_drawn(), start.largest);
  if (base->of_one_size()) largest = std::max(largest, grains.diameter);
  for (const auto& grain : placed) largest = std::max(largest, grain.diameter);
  return largest;
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

MaterialLaws Scene::material_laws() const {
  const auto of_pair = [](const MaterialContact& between) { return between.laws(); };
  const auto count = material_names().size();
  auto table = table_of<ContactLaws>(*this, contact.laws(), of_pair);
  for (std::size_t a = 0; a < count && has_moduli(); ++a) {
    for (std::size_t b = 0; b < count; ++b) set_moduli(table[a * count + b], elasticity(a), elasticity(b));
  }
  for (auto& laws : table) set_adhesion(laws);
  return {count, std::move(table)};
}

ImpulseLaws Scene::impulse_laws() const {
  const auto of_pair = [](const MaterialContact& between) { return between.impulse; };
  return {table_of<ImpulseLaw>(*this, contact.impulse, of_pair), material_names().size()};
}

}  // namespace repose
