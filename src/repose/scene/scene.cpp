// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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

bool Scene::draws_grains() const {
  return source->released() > 0 || source->placed() > 0 || (base->of_grains() && !base->of_one_size());
}

double Scene::smallest_diameter() const {
  double smallest = std::numeric_limits<double>::infinity();
  if (draws_grains()) smallest = smallest_drawn();
  if (base->of_one_size()) smallest = std::min(smallest, grains.diameter);
  if (start.largest > 0.0) smallest = std::min(smallest, start.smallest);
  for (const auto& grain : placed) smallest = std::min(smallest, grain.diameter);
  return std::isfinite(smallest) ? smallest : smallest_drawn();
}

double Scene::largest_diameter() const {
  double largest = start.largest;
  if (draws_grains()) largest = std::max(largest, largest_drawn());
  if (base->of_one_size()) largest = std::max(largest, grains.diameter);
  for (const auto& grain : placed) largest = std::max(largest, grain.diameter);
  return largest > 0.0 ? largest : largest_drawn();
}

namespace {

/// Mass and diameter of the mean moving grain of a scene that has none of the nominal size: placed, or of its start.
struct MeanGrain {
  double mass = 0.0;
  double diameter = 0.0;
  double count = 0.0;
};

std::optional<MeanGrain> mean_grain(const Scene& scene) {
  const double d = scene.grains.diameter;
  if (scene.draws_grains() || scene.base->of_one_size()) return std::nullopt;
  if (scene.smallest_diameter() <= d && d <= scene.largest_diameter()) return std::nullopt;
  MeanGrain mean{scene.start.total_mass, scene.start.total_size, static_cast<double>(scene.start.moving)};
  for (const auto& grain : scene.placed) {
    if (grain.fixed) continue;
    mean.mass += scene.mass_of(grain.diameter, grain.material);
    mean.diameter += grain.diameter;
    mean.count += 1.0;
  }
  if (!(mean.count > 0.0)) return std::nullopt;
  return MeanGrain{mean.mass / mean.count, mean.diameter / mean.count, mean.count};
}

}  // namespace

double Scene::usual_mass() const {
  const auto mean = mean_grain(*this);
  return mean ? mean->mass : nominal_mass();
}

double Scene::usual_diameter() const {
  const auto mean = mean_grain(*this);
  return mean ? mean->diameter : grains.diameter;
}

template <int D>
Vec<D> Scene::gravity_vector() const {
  Vec<D> vector;
  vector[up<D>] = -gravity;
  const auto direction = vec<D>(gravity_direction);
  Vec<D> down;
  down[up<D>] = -1.0;
  // Written out for the usual direction, in which no root rounds.
  if (direction == down || !(magnitude(direction) > 0.0)) return vector;
  return direction * (gravity / magnitude(direction));
}
template Vec<2> Scene::gravity_vector() const;
template Vec<3> Scene::gravity_vector() const;

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
