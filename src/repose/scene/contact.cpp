// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/contact.hpp"

#include "repose/laws/impact.hpp"
#include "repose/scene/keys.hpp"
#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace repose {

namespace {

/// Each law of a kind with its defaults.
template <class Law, std::size_t... K>
std::vector<Law> all_of(std::index_sequence<K...>) {
  return {Law(std::in_place_index<K>)...};
}
template <class Law>
std::vector<Law> all_of() {
  return all_of<Law>(std::make_index_sequence<std::variant_size_v<Law>>());
}

template <class Law>
std::string name_of(const Law& law) {
  return std::visit([](const auto& one) { return std::string(one.name); }, law);
}

/// The scales for a contact of two materials, given by their numbers.
LawScales scales_of(const Scene& scene, double friction, std::size_t first, std::size_t second) {
  const double weight = scene.nominal_mass() * scene.gravity;
  LawScales scales{scene.gravity, weight > 0.0 ? weight : 1.0, scene.grains.diameter, friction};
  if (scene.has_moduli()) scales.ratio = stiffness_ratio(scene.elasticity(first), scene.elasticity(second));
  return scales;
}

/// Hertz's law takes its stiffness from the moduli of the materials where they have some.
void choose_hertz(NormalLaw& law, const Scene& scene) {
  const auto as_given = [](auto to, const auto& from) {
    to.damping = from.damping;
    to.attraction = from.attraction;
    to.damping_kind = from.damping_kind;
    to.restitution = from.restitution;
    return to;
  };
  if (!scene.has_moduli()) {
    if (const auto* elastic = std::get_if<ElasticHertz>(&law)) law = as_given(Hertz{.stiffness = unset}, *elastic);
    return;
  }
  if (const auto* plain = std::get_if<Hertz>(&law)) law = as_given(ElasticHertz{}, *plain);
  if (auto* elastic = std::get_if<ElasticHertz>(&law)) {
    elastic->modulus = effective_modulus(scene.elasticity(0), scene.elasticity(0));
  }
}

/// The keys of one law of a kind: which it is, and its parameters.
template <class Law, class Adapt>
void law_keys(const std::string& prefix, Law& law, std::string_view about, const LawScales& scales, Parameters& keys,
              const Adapt& adapt) {
  const auto all = all_of<Law>();
  std::vector<std::string> names;
  for (const auto& one : all) {
    if (std::find(names.begin(), names.end(), name_of(one)) == names.end()) names.push_back(name_of(one));
  }
  const std::vector<Word> words(names.begin(), names.end());
  std::string name = name_of(law);
  keys.choice(prefix + "law", name, std::string_view(names.front()), words, about);
  for (const auto& one : all) {
    if (name_of(one) == name && name != name_of(law)) law = one;
  }
  adapt(law);
  Prefixed below(prefix, keys);
  std::visit([&](auto& one) { parameters(one, below, scales); }, law);
}

template <class Law>
void law_keys(const std::string& prefix, Law& law, std::string_view about, const LawScales& scales, Parameters& keys) {
  law_keys(prefix, law, about, scales, keys, [](const Law&) {});
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

/// The laws of a pair of materials. A kind of law that the pair does not give is as in `like`.
void force_law_keys(MaterialContact& contact, const MaterialContact* like, const LawScales& scales, const Scene& scene,
                    Parameters& keys) {
  const auto own = [&](std::string_view kind) { return like == nullptr || keys.given(kind); };
  if (own("normal")) {
    law_keys("normal.", contact.normal, "normal force", scales, keys,
             [&](NormalLaw& law) { choose_hertz(law, scene); });
    if (std::holds_alternative<ElasticHertz>(contact.normal)) {
      keys.optional_number("normal.stiffness", contact.second_stiffness, {"", "by the moduli of the materials"}, any,
                           "", "of materials without moduli");
    }
    contact.normal = with_restitution(contact.normal, scene.nominal_mass(), scene.grains.diameter);
  } else {
    contact.normal = like->normal;
  }
  if (own("tangential")) {
    law_keys("tangential.", contact.tangential, "tangential force", scales, keys);
  } else {
    contact.tangential = with_friction(like->tangential, contact.friction);
    auto* mindlin = std::get_if<Mindlin>(&contact.tangential);
    if (mindlin != nullptr && scene.has_moduli()) mindlin->ratio = scales.ratio;
  }
  if (own("rolling")) {
    law_keys("rolling.", contact.rolling, "resistance to rolling", scales, keys);
  } else {
    contact.rolling = like->rolling;
  }
  if (scene.dimension == 3 && own("twisting")) {
    law_keys("twisting.", contact.twisting, "resistance to twisting, the relative spin about the normal", scales, keys);
  } else if (scene.dimension == 3) {
    contact.twisting = like->twisting;
  }
  if (own("cohesion")) {
    law_keys("cohesion.", contact.cohesion, "attraction", scales, keys);
  } else {
    contact.cohesion = like->cohesion;
  }
}

/// The law of rigid grains. What is not said of a pair is as in `like`; `rule` says so, or is the usual rule.
struct UsualImpulse {
  ImpulseLaw law;
  std::string_view friction_rule;
  std::string_view rolling_rule;
  std::string_view rule;
};

void impulse_keys(ImpulseLaw& law, const UsualImpulse& usual, const Scene& scene, Parameters& keys) {
  const auto& like = usual.law;
  keys.number("friction", law.friction, {like.friction, usual.friction_rule}, not_negative_or_infinite, "",
              "Coulomb coefficient mu; inf: no sliding");
  keys.number("restitution", law.restitution, {like.restitution, usual.rule}, zero_to_one, "",
              "normal velocity after an impact over that before");
  keys.number("tangential_restitution", law.tangential_restitution, {like.tangential_restitution, usual.rule},
              {.low = -1.0, .high = 1.0}, "", "the same for the tangential velocity, as far as friction allows");
  keys.number("rolling_friction", law.rolling_friction, {like.rolling_friction, usual.rolling_rule},
              not_negative_or_infinite, "",
              "tan(theta_r): torque over normal force and roll radius 2 r_i r_j/(r_i + r_j) at most; inf: no rolling");
  if (scene.dimension == 3) {
    keys.number("twisting_friction", law.twisting_friction, {like.twisting_friction, usual.rule},
                not_negative_or_infinite, "",
                "torque about the normal over normal force and roll radius at most; inf: no twisting");
  }
  keys.number("weakening_velocity", law.weakening_velocity, {like.weakening_velocity, usual.rule}, not_negative, "L/T",
              "slip at which friction has fallen to dynamic_friction, linearly; 0: it does not weaken");
  if (!(law.weakening_velocity > 0.0)) return void(law.dynamic_friction = 0.0);
  keys.number("dynamic_friction", law.dynamic_friction,
              like.weakening_velocity > 0.0 ? Default{like.dynamic_friction, usual.rule} : Default{required},
              not_negative, "", "friction of contacts that slide at weakening_velocity or faster");
}

/// What a scene says of rolling by its critical angle.
UsualImpulse usual_impulse(const Scene& scene) {
  UsualImpulse usual{{}, "0.5; inf with a method.critical_angle", "0; tan of a method.critical_angle", ""};
  usual.law.friction = 0.5;
  if (const auto angle = scene.method->usual_rolling_angle()) {
    usual.law.friction = std::numeric_limits<double>::infinity();
    usual.law.rolling_friction = rolling_friction_of(*angle);
  }
  return usual;
}

void check_impulse(const std::string& prefix, const ImpulseLaw& law, const Scene& scene, Problems& problems) {
  if (law.weakening_velocity > 0.0 && law.dynamic_friction > law.friction &&
      problems.sound(prefix + "dynamic_friction")) {
    problems.problem(prefix + "dynamic_friction",
                     fmt::format(" = {}: must be at most {}friction = {}", law.dynamic_friction, prefix, law.friction));
  }
  if (law.weakening_velocity > 0.0 && !std::isfinite(law.friction) && problems.sound(prefix + "weakening_velocity")) {
    problems.problem(prefix + "weakening_velocity",
                     fmt::format(" = {}: infinite friction cannot weaken", law.weakening_velocity));
  }
  const auto angle = scene.method->usual_rolling_angle();
  if (prefix == "contact." && angle && law.rolling_friction != rolling_friction_of(*angle) &&
      problems.sound("contact.rolling_friction")) {
    problems.problem("contact.rolling_friction",
                     fmt::format(" = {}: method.critical_angle = {} says {:.6g}; give one", law.rolling_friction,
                                 *angle, rolling_friction_of(*angle)));
  }
}

bool is_hertz(const NormalLaw& law) {
  return std::holds_alternative<Hertz>(law) || std::holds_alternative<ElasticHertz>(law);
}

void check_force_laws(const std::string& prefix, const MaterialContact& contact, const Scene& scene,
                      Problems& problems) {
  if (std::holds_alternative<Continuous>(contact.normal) && scene.gravity == 0.0 && problems.sound("gravity")) {
    problems.problem("gravity", " = 0: the continuous law has its force scale from gravity; use hooke or gravity > 0");
  }
  const auto law_key = prefix + "normal.law";
  if (scene.has_moduli() && !std::holds_alternative<ElasticHertz>(contact.normal) && problems.sound(law_key)) {
    problems.problem(law_key, fmt::format(" = \"{}\": must be \"hertz\", which alone takes the young_modulus of the "
                                          "materials",
                                          name_of(contact.normal)));
  }
  if (contact.second_stiffness) {
    problems.problem(
        prefix + "normal.stiffness",
        fmt::format(" = {}: the stiffness follows from the young_modulus of the materials; give one of the "
                    "two",
                    *contact.second_stiffness));
  }
  const auto key = prefix + "normal.restitution";
  std::visit(
      [&](const auto& law) {
        if (std::isfinite(law.damping) || !problems.sound(key)) return;
        problems.problem(key, fmt::format(" = {}: is less than any damping of this law gives", law.restitution));
      },
      contact.normal);
  if (std::holds_alternative<Mindlin>(contact.tangential) && !is_hertz(contact.normal) &&
      problems.sound(prefix + "tangential.law") && problems.sound(prefix + "normal.law")) {
    problems.problem(prefix + "tangential.law", fmt::format(" = \"mindlin\": needs {}normal.law = \"hertz\"", prefix));
  }
}

void check_adhesion(const std::string& prefix, const MaterialContact& contact, Problems& problems) {
  if (!std::holds_alternative<Jkr>(contact.cohesion) || is_hertz(contact.normal)) return;
  if (!problems.sound(prefix + "cohesion.law") || !problems.sound(prefix + "normal.law")) return;
  problems.problem(prefix + "cohesion.law", fmt::format(" = \"jkr\": needs {}normal.law = \"hertz\"", prefix));
}

void check_between(const std::string& prefix, const MaterialContact& contact, const Scene& scene, Problems& problems) {
  const auto traits = scene.method->traits();
  if (traits.impulse_laws) check_impulse(prefix, contact.impulse, scene, problems);
  if (!traits.force_laws) return;
  check_force_laws(prefix, contact, scene, problems);
  check_adhesion(prefix, contact, problems);
}

/// A ratio of stiffnesses that agrees with the materials.
void check_ratio(const std::string& prefix, const MaterialContact& contact, const LawScales& scales, const Scene& scene,
                 Problems& problems) {
  const auto* law = std::get_if<Mindlin>(&contact.tangential);
  const auto key = prefix + "tangential.ratio";
  if (law == nullptr || !scene.has_moduli() || law->ratio == scales.ratio || !problems.none()) return;
  problems.problem(key, fmt::format(" = {}: the poisson_ratio of the materials gives {:.6g}; give one of the two",
                                    law->ratio, scales.ratio));
}

/// The parameters of a law, name by name.
class LawText final : public Parameters {
 public:
  std::string text;

 private:
  void show(const Item& item) override {
    if (const auto* number = std::get_if<Number>(&item.value)) {
      text += fmt::format(", {} {:g}", item.name, number->value);
    } else if (const auto* flag = std::get_if<Flag>(&item.value); flag == nullptr || *flag->value) {
      text += fmt::format(", {}", item.name);
    }
  }
};

template <class Law>
std::string law_text(Law law, const LawScales& scales) {
  LawText shown;
  std::visit(
      [&](auto& one) {
        shown.text = one.name;
        constexpr bool of_contact = std::is_same_v<Law, TangentialLaw>;
        if constexpr (of_contact && requires { one.friction; }) {
          shown.text += fmt::format(", friction {:g}", one.friction);
        }
        parameters(one, shown, scales);
      },
      law);
  return shown.text;
}

std::string force_laws_text(const MaterialContact& contact, const Scene& scene) {
  const auto scales = scales_of(scene, contact.friction, 0, 0);
  std::string text = fmt::format("normal law       {}\n", law_text(contact.normal, scales));
  text += fmt::format("tangential law   {}\n", law_text(contact.tangential, scales));
  if (contact.rolling.index() > 0) text += fmt::format("rolling          {}\n", law_text(contact.rolling, scales));
  if (contact.twisting.index() > 0) text += fmt::format("twisting         {}\n", law_text(contact.twisting, scales));
  if (contact.cohesion.index() > 0) text += fmt::format("cohesion         {}\n", law_text(contact.cohesion, scales));
  return text;
}

std::string impulse_text(const MaterialContact& contact, const Scene&) {
  const auto& law = contact.impulse;
  std::string text = fmt::format("rigid contacts   friction {:g}, restitution {:g}", law.friction, law.restitution);
  if (law.tangential_restitution != 0.0) text += fmt::format(", tangential {:g}", law.tangential_restitution);
  if (law.rolling_friction > 0.0) text += fmt::format(", rolling friction {:g}", law.rolling_friction);
  if (law.twisting_friction > 0.0) text += fmt::format(", twisting friction {:g}", law.twisting_friction);
  if (law.weakening_velocity > 0.0) {
    text += fmt::format(", friction {:g} from slip {:g} on", law.dynamic_friction, law.weakening_velocity);
  }
  return text + "\n";
}

template <class Text>
std::string of_all_pairs(const Scene& scene, const Text& text_of) {
  std::string text = text_of(scene.contact, scene);
  for (const auto& pair : scene.pairs) {
    text += fmt::format("between          {} and {}\n{}", pair.first, pair.second, text_of(pair.contact, scene));
  }
  return text;
}

}  // namespace

void material_key(std::string_view key, std::string& material, const Scene& scene, Parameters& keys) {
  const auto names = scene.material_names();
  const std::vector<Word> words(names.begin(), names.end());
  keys.choice(key, material, {names.front(), "the first material"}, words, "its material, for the laws of the pair");
}

namespace {

LawScales scales_of(const Scene& scene, const MaterialPair& pair) {
  return scales_of(scene, pair.contact.friction, scene.material_number(pair.first), scene.material_number(pair.second));
}

/// Adhesion is a matter of small contact areas: a bond across a gap that is large against a grain is refused.
void check_bonds(const Scene& scene, Problems& problems) {
  if (!scene.method->traits().force_laws || !problems.none()) return;
  constexpr double longest = 0.2;  // smallest diameters
  const auto laws = scene.material_laws();
  const auto judge = [&](const std::string& prefix, std::size_t a, std::size_t b) {
    const auto* adhesion = std::get_if<Jkr>(&laws.table[a * laws.materials + b].cohesion);
    const auto key = prefix + "cohesion.surface_energy";
    if (adhesion == nullptr || !problems.sound(key)) return;
    const double gap = reach_of_bonds(*adhesion, scene.smallest_diameter()) - 1.0;
    if (!(gap > longest)) return;
    problems.problem(
        key, fmt::format(" = {}: a bond to a wall would bridge a gap of {:.3g} diameters of the smallest grain; at "
                         "most {}: grains are too soft for it",
                         adhesion->surface_energy, gap, longest));
  };
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const auto& pair = scene.pairs[k];
    judge(fmt::format("pair[{}].", k), scene.material_number(pair.first), scene.material_number(pair.second));
  }
  for (std::size_t a = 0; a < laws.materials && problems.none(); ++a) {
    for (std::size_t b = a; b < laws.materials; ++b) judge("contact.", a, b);
  }
}

}  // namespace

void contact_keys(Scene& scene, Parameters& keys) {
  const auto traits = scene.method->traits();
  material_keys(scene, keys);
  Prefixed below("contact.", keys);
  if (traits.impulse_laws) impulse_keys(scene.contact.impulse, usual_impulse(scene), scene, below);
  if (traits.force_laws) {
    below.number("friction", scene.contact.friction, 0.5, not_negative, "", "Coulomb coefficient mu");
    force_law_keys(scene.contact, nullptr, scales_of(scene, scene.contact.friction, 0, 0), scene, below);
  }
  table_keys(keys, "pair", scene.pairs, [&](Parameters& entry, MaterialPair& pair, std::size_t) {
    material_key("first", pair.first, scene, entry);
    material_key("second", pair.second, scene, entry);
    constexpr std::string_view rule = "as under [contact]";
    if (traits.impulse_laws)
      impulse_keys(pair.contact.impulse, {scene.contact.impulse, rule, rule, rule}, scene, entry);
    if (!traits.force_laws) return;
    entry.number("friction", pair.contact.friction, {scene.contact.friction, rule}, not_negative, "",
                 "as contact.friction");
    force_law_keys(pair.contact, &scene.contact, scales_of(scene, pair), scene, entry);
  });
}

void check_contact(const Scene& scene, Problems& problems) {
  check_materials(scene, problems);
  check_between("contact.", scene.contact, scene, problems);
  check_ratio("contact.", scene.contact, scales_of(scene, scene.contact.friction, 0, 0), scene, problems);
  std::set<std::pair<std::string, std::string>> given;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const auto& pair = scene.pairs[k];
    const auto prefix = fmt::format("pair[{}].", k);
    check_between(prefix, pair.contact, scene, problems);
    check_ratio(prefix, pair.contact, scales_of(scene, pair), scene, problems);
    if (!given.insert(std::minmax(pair.first, pair.second)).second) {
      problems.problem(prefix + "second", fmt::format(" = \"{}\": this pair is given twice", pair.second));
    }
  }
  check_bonds(scene, problems);
}

std::string describe_force_laws(const Scene& scene) { return of_all_pairs(scene, force_laws_text); }
std::string describe_impulse_laws(const Scene& scene) { return of_all_pairs(scene, impulse_text); }

}  // namespace repose
