// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/methods/hybrid.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

/// A law of rigid grains has more than hard collisions know.
void check_hybrid_law(const std::string& prefix, const ImpulseLaw& law, Problems& problems) {
  const auto refuse = [&](const std::string& key, double value, const char* why) {
    if (problems.sound(prefix + key)) problems.problem(prefix + key, fmt::format(" = {}: {}", value, why));
  };
  if (law.tangential_restitution != 0.0) {
    refuse("tangential_restitution", law.tangential_restitution, "must be 0: surfaces stop or slip in a collision");
  }
  if (law.weakening_velocity != 0.0) refuse("weakening_velocity", law.weakening_velocity, "must be 0");
  if (!std::isfinite(law.rolling_friction)) refuse("rolling_friction", law.rolling_friction, "must be finite");
}

}  // namespace

double HybridMethod::stiffness(const Scene& scene) const {
  constexpr double usual = 1e4;  // m g / d
  return given_stiffness ? *given_stiffness : usual * scene.nominal_mass() * scene.gravity / scene.grains.diameter;
}

double HybridMethod::damping(const Scene& scene) const {
  return given_damping ? *given_damping : std::sqrt(scene.nominal_mass() * stiffness(scene));
}

double HybridMethod::slip_drag(const Scene& scene) const { return given_slip_drag ? *given_slip_drag : damping(scene); }

double HybridMethod::static_friction(const Scene& scene) const {
  return given_static_friction ? *given_static_friction : scene.contact.impulse.friction;
}

double HybridMethod::automatic_step(const Scene& scene) const {
  constexpr double phase = 2.0;  // of an oscillation of a grain on a contact: implicit steps are stable at any
  return phase * std::sqrt(scene.nominal_mass() / stiffness(scene));
}

void HybridMethod::check(const Scene& scene, Problems& problems) const {
  if (!problems.none()) return;
  if (!given_stiffness && !(scene.gravity > 0.0)) {
    return problems.problem("method.stiffness", " = \"auto\": without gravity it must be given [M/T^2]");
  }
  check_hybrid_law("contact.", scene.contact.impulse, problems);
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    check_hybrid_law(fmt::format("pair[{}].", k), scene.pairs[k].contact.impulse, problems);
  }
  if (!std::isfinite(static_friction(scene))) {
    problems.problem("method.static_friction", ": contact.friction is infinite: give a number");
  }
  if (!scene.pieces.empty())
    problems.problem("wall", ": method.kind = \"hybrid\" knows endless walls alone: [[plane]]");
  if (!scene.drums.empty()) problems.problem("drum", ": method.kind = \"hybrid\" knows endless walls alone: [[plane]]");
  if (!scene.loads.empty()) problems.problem("load", ": method.kind = \"hybrid\" knows no loads");
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const auto& plane = scene.planes[k];
    if (plane.motion->motion(Dimension<2>{}).kind == WallMotion<2>::Kind::none && !plane.opens_at) continue;
    problems.problem(fmt::format("plane[{}]", k), ": method.kind = \"hybrid\" needs walls that stand still and stay");
  }
}

std::string HybridMethod::describe(const Scene& scene) const {
  const double weight = scene.nominal_mass() * scene.gravity;
  std::string text = describe_impulse_laws(scene);
  text +=
      fmt::format("soft contacts    stiffness {:g}{}, damping {:g}, slip drag {:g}\n", stiffness(scene),
                  weight > 0.0 ? fmt::format(" ({:g} m g / d)", stiffness(scene) * scene.grains.diameter / weight) : "",
                  damping(scene), slip_drag(scene));
  text += fmt::format("static friction  {:g} at walls, over {:g}{}\n", static_friction(scene), well_width,
                      pin_base.value_or(false) ? ", but the base is pinned in x" : "");
  text += fmt::format("time step        {:.6g} ({})\n", time_step(scene), step ? "given" : "auto");
  text += fmt::format("solver           {}, residual {:g} grain weights{}\n", algorithm, tolerance,
                      relax.value_or(false) ? ", relaxed before time begins" : "");
  return text;
}

}  // namespace repose
