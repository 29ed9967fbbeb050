// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/laws/impact.hpp"
#include "repose/scene/key_groups.hpp"

#include <fmt/format.h>

#include <limits>

namespace repose {

namespace {

/// Shows the parameters of a law as keys of a scene.
class LawParameters final : public Parameters {
 public:
  LawParameters(std::string prefix, Keys& keys) : prefix_(std::move(prefix)), keys_(keys) {}
  void number(std::string_view name, double& value, double fallback, const Bounds& bounds, std::string_view unit,
              std::string_view about) override {
    keys_.number(prefix_ + std::string(name), value, fallback, bounds, unit, about);
  }
  void flag(std::string_view name, bool& value, bool fallback, std::string_view about) override {
    keys_.flag(prefix_ + std::string(name), value, fallback, about);
  }
  void one_of(const std::vector<Way>& ways, std::size_t& way, double& value, double fallback) override {
    keys_.one_of(prefix_, ways, way, value, fallback);
  }

 private:
  std::string prefix_;
  Keys& keys_;
};

/// Each law of a kind, as it is before anything is known of it.
template <class Law, std::size_t... K>
std::vector<Law> all_of(std::index_sequence<K...>) {
  return {Law(std::in_place_index<K>)...};
}
template <class Law>
std::vector<Law> all_of() {
  return all_of<Law>(std::make_index_sequence<std::variant_size_v<Law>>());
}

std::string name_of(const auto& law) {
  return std::visit([](const auto& one) { return std::string(one.name); }, law);
}

/// The keys of one law of a kind: which it is, and its parameters.
template <class Law>
void one_law(const std::string& prefix, Law& law, const std::string& fallback, std::string_view about,
             const LawScales& scales, Keys& keys) {
  const auto all = all_of<Law>();
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(name_of(one));
  std::string name = name_of(law);
  keys.choice(prefix + "law", name, fallback, names, about);
  for (const auto& one : all) {
    if (name_of(one) == name && name != name_of(law)) law = one;
  }
  LawParameters shown(prefix, keys);
  std::visit([&](auto& one) { parameters(one, shown, scales); }, law);
}

/// The law as it is for another pair of materials, with the friction of this one.
TangentialLaw with_friction(TangentialLaw law, double friction) {
  std::visit(
      [&](auto& one) {
        if constexpr (requires { one.friction; }) one.friction = friction;
      },
      law);
  return law;
}

/// The law of rigid grains. What is not said of a pair is as in `like`.
void impulse_keys(const std::string& prefix, ImpulseLaw& law, const ImpulseLaw& like, Keys& keys) {
  keys.number(prefix + "friction", law.friction, like.friction, not_negative_or_infinite, "",
              "Coulomb coefficient mu; inf: no sliding");
  keys.number(prefix + "restitution", law.restitution, like.restitution, {.low = 0.0, .high = 1.0}, "",
              "normal velocity after an impact over that before");
  keys.number(prefix + "tangential_restitution", law.tangential_restitution, like.tangential_restitution,
              {.low = -1.0, .high = 1.0}, "", "the same of the tangential velocity, where friction can bring it about");
  keys.number(prefix + "rolling_friction", law.rolling_friction, like.rolling_friction, not_negative_or_infinite, "",
              "tan(theta_r): torque over normal force and roll radius 2 r_i r_j/(r_i + r_j) at most; inf: no rolling");
  keys.number(prefix + "weakening_velocity", law.weakening_velocity, like.weakening_velocity, not_negative, "L/T",
              "slip at which friction has fallen to dynamic_friction, linearly; 0: it does not weaken");
  if (!(law.weakening_velocity > 0.0)) return;
  keys.number(prefix + "dynamic_friction", law.dynamic_friction,
              like.weakening_velocity > 0.0 ? like.dynamic_friction : required, not_negative, "",
              "friction of contacts that slide so fast");
}

/// What a scene says of rolling by its critical angle.
ImpulseLaw usual_impulse_law(const Scene& scene) {
  ImpulseLaw law;
  law.friction = 0.5;
  if (scene.method.rolling_angle) {
    law.friction = std::numeric_limits<double>::infinity();
    law.rolling_friction = rolling_friction_of(*scene.method.rolling_angle);
  }
  return law;
}

/// The laws of a pair of materials. A kind of law of which nothing is said is as in `like`.
void contact_keys(const std::string& prefix, Scene::Contact& contact, const Scene::Contact* like, const Scene& scene,
                  Keys& keys) {
  const double weight = scene.grain_weight();
  const LawScales scales{scene.gravity, weight > 0.0 ? weight : 1.0, scene.grains.diameter, contact.friction};
  const auto own = [&](const std::string& kind) { return like == nullptr || keys.given(prefix + kind); };
  if (own("normal")) {
    one_law(prefix + "normal.", contact.normal, "continuous", "normal force", scales, keys);
    contact.normal = with_restitution(contact.normal, scene.grains.mass, scene.grains.diameter);
  } else {
    contact.normal = like->normal;
  }
  if (own("tangential")) {
    one_law(prefix + "tangential.", contact.tangential, "cumulative", "tangential force", scales, keys);
  } else {
    contact.tangential = with_friction(like->tangential, contact.friction);
  }
  if (own("rolling")) {
    one_law(prefix + "rolling.", contact.rolling, "none", "resistance to rolling", scales, keys);
  } else {
    contact.rolling = like->rolling;
  }
  if (own("cohesion")) {
    one_law(prefix + "cohesion.", contact.cohesion, "none", "attraction", scales, keys);
  } else {
    contact.cohesion = like->cohesion;
  }
}

}  // namespace

void material_key(const std::string& key, std::string& material, const Scene& scene, Keys& keys) {
  const auto names = scene.material_names();
  keys.choice(key, material, names.front(), names, "of which it is, for the laws of the pair");
}

void law_keys(Scene& scene, Keys& keys) {
  if (scene.method.rigid()) {
    impulse_keys("contact.", scene.contact.impulse, usual_impulse_law(scene), keys);
  } else {
    keys.number("contact.friction", scene.contact.friction, 0.5, not_negative, "", "Coulomb coefficient mu");
    contact_keys("contact.", scene.contact, nullptr, scene, keys);
  }
  table_keys<Scene::Material>(keys, "material", scene.materials, [&](const auto& prefix, auto& material, std::size_t) {
    keys.text(prefix + "name", material.name, "", "of the material; that of the first is for all that names none");
    keys.number(prefix + "density", material.density, 1.0, positive, "",
                "over that of grains.mass and grains.diameter");
  });
  table_keys<Scene::Pair>(keys, "pair", scene.pairs, [&](const auto& prefix, auto& pair, std::size_t) {
    material_key(prefix + "first", pair.first, scene, keys);
    material_key(prefix + "second", pair.second, scene, keys);
    if (scene.method.rigid()) return impulse_keys(prefix, pair.contact.impulse, scene.contact.impulse, keys);
    keys.number(prefix + "friction", pair.contact.friction, scene.contact.friction, not_negative, "",
                "as contact.friction");
    contact_keys(prefix, pair.contact, &scene.contact, scene, keys);
  });
}

}  // namespace repose
