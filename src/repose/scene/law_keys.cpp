// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

namespace repose {

namespace {

void normal_keys(Scene& scene, Keys& keys) {
  static const std::vector<std::string> laws = {"continuous", "hooke"};
  std::string law = laws[scene.contact.normal.index()];
  keys.choice("contact.normal.law", law, "continuous", laws, "normal force");
  const bool same = law == laws[scene.contact.normal.index()];
  if (law == "hooke") {
    auto hooke = same ? std::get<Hooke>(scene.contact.normal) : Hooke{};
    const double weight = scene.grain_weight();
    keys.number("contact.normal.stiffness", hooke.stiffness, 500.0 * (weight > 0 ? weight : 1) / scene.grains.diameter,
                positive, "M/T^2", "spring constant k");
    keys.number("contact.normal.damping", hooke.damping, 0.5, not_negative, "", "fraction of critical");
    keys.flag("contact.normal.attraction", hooke.attraction, false, "let the dashpot pull");
    scene.contact.normal = hooke;
  } else {
    auto continuous = same ? std::get<Continuous>(scene.contact.normal) : Continuous{};
    keys.number("contact.normal.exponent", continuous.exponent, 36.0, positive, "", "n of F = m g (s/r)^(n+1)");
    keys.number("contact.normal.cutoff", continuous.cutoff, 1.2, at_least_one, "diameters",
                "r0: the force acts at distances below this; at least 1, where grains touch");
    keys.number("contact.normal.damping", continuous.damping, 0.5, not_negative, "", "fraction of critical");
    keys.flag("contact.normal.attraction", continuous.attraction, false, "let the dashpot pull");
    scene.contact.normal = Continuous::make(continuous.exponent, continuous.cutoff, continuous.damping, scene.gravity,
                                            continuous.attraction);
  }
}

void tangential_keys(Scene& scene, Keys& keys) {
  static const std::vector<std::string> laws = {"cumulative", "linear", "none"};
  std::string law = laws[scene.contact.tangential.index()];
  keys.choice("contact.tangential.law", law, "cumulative", laws, "tangential force");
  const bool same = law == laws[scene.contact.tangential.index()];
  if (law == "cumulative") {
    auto cumulative = same ? std::get<Cumulative>(scene.contact.tangential) : Cumulative{};
    keys.number("contact.tangential.alpha", cumulative.alpha, 1.214, positive, "",
                "largest displacement over friction times normal engagement");
    cumulative.friction = scene.contact.friction;
    scene.contact.tangential = cumulative;
  } else if (law == "linear") {
    auto linear = same ? std::get<Linear>(scene.contact.tangential) : Linear{};
    keys.number("contact.tangential.stiffness", linear.stiffness, required, positive, "M/T^2", "spring constant k_t");
    keys.number("contact.tangential.damping", linear.damping, 0.0, not_negative, "", "fraction of critical");
    linear.friction = scene.contact.friction;
    scene.contact.tangential = linear;
  } else {
    scene.contact.tangential = None{};
  }
}

}  // namespace

void law_keys(Scene& scene, Keys& keys) {
  keys.number("contact.friction", scene.contact.friction, 0.5, not_negative, "", "Coulomb coefficient mu");
  normal_keys(scene, keys);
  tangential_keys(scene, keys);
}

}  // namespace repose
