// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace repose {

namespace {

void check_impulse(const std::string& prefix, const ImpulseLaw& law, const Scene& scene, Reader& reader) {
  if (law.weakening_velocity > 0.0 && law.dynamic_friction > law.friction &&
      reader.sound(prefix + "dynamic_friction")) {
    reader.problem(prefix + "dynamic_friction",
                   fmt::format(" = {}: must be at most {}friction = {}", law.dynamic_friction, prefix, law.friction));
  }
  if (law.weakening_velocity > 0.0 && !std::isfinite(law.friction) && reader.sound(prefix + "weakening_velocity")) {
    reader.problem(prefix + "weakening_velocity",
                   fmt::format(" = {}: infinite friction cannot weaken", law.weakening_velocity));
  }
  const auto& angle = scene.method.rolling_angle;
  if (prefix == "contact." && angle && law.rolling_friction != rolling_friction_of(*angle) &&
      reader.sound("contact.rolling_friction")) {
    reader.problem("contact.rolling_friction", fmt::format(" = {}: method.critical_angle = {} says {:.6g}; give one",
                                                           law.rolling_friction, *angle, rolling_friction_of(*angle)));
  }
}

void check_contact(const std::string& prefix, const Scene::Contact& contact, const Scene& scene, Reader& reader) {
  if (scene.method.rigid()) return check_impulse(prefix, contact.impulse, scene, reader);
  if (std::holds_alternative<Continuous>(contact.normal) && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("gravity", " = 0: the continuous law has its force scale from gravity; use hooke or gravity > 0");
  }
  const auto key = prefix + "normal.restitution";
  std::visit(
      [&](const auto& law) {
        if (std::isfinite(law.damping) || !reader.sound(key)) return;
        reader.problem(key, fmt::format(" = {}: is less than any damping of this law gives", law.restitution));
      },
      contact.normal);
  if (std::holds_alternative<Mindlin>(contact.tangential) && !std::holds_alternative<Hertz>(contact.normal) &&
      reader.sound(prefix + "tangential.law") && reader.sound(prefix + "normal.law")) {
    reader.problem(prefix + "tangential.law",
                   fmt::format(" = \"mindlin\": goes with {}normal.law = \"hertz\" alone", prefix));
  }
}

void check_materials(const Scene& scene, Reader& reader) {
  constexpr std::size_t most = 64;
  if (scene.materials.size() > most) reader.problem("material", fmt::format(": at most {} materials", most));
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    const auto key = fmt::format("material[{}].name", k);
    const auto& name = scene.materials[k].name;
    if (name.empty() && reader.sound(key)) reader.problem(key, ": missing: a material needs a name");
    if (!name.empty() && !names.insert(name).second) reader.problem(key, fmt::format(" = \"{}\": is taken", name));
  }
  std::set<std::pair<std::string, std::string>> given;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const auto& pair = scene.pairs[k];
    const auto prefix = fmt::format("pair[{}].", k);
    check_contact(prefix, pair.contact, scene, reader);
    if (!given.insert(std::minmax(pair.first, pair.second)).second) {
      reader.problem(prefix + "second", fmt::format(" = \"{}\": this pair was given before", pair.second));
    }
  }
}

}  // namespace

void check_laws(const Scene& scene, Reader& reader) {
  check_contact("contact.", scene.contact, scene, reader);
  check_materials(scene, reader);
}

}  // namespace repose
