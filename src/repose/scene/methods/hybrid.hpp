// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Hard collisions while grains fly, soft implicit steps where they rest.
struct HybridMethod final : KindOf<HybridMethod, MethodKind> {
  static constexpr std::string_view kind = "hybrid";
  static constexpr std::string_view meaning = "by hard collisions in flight, by soft implicit steps at rest";

  std::optional<double> step;             ///< [T]; none: "auto"
  std::optional<double> given_stiffness;  ///< [M/T^2]; none: "auto"
  std::optional<double> given_damping;    ///< [M/T]; none: "auto"
  std::optional<double> given_slip_drag;  ///< [M/T]; none: "auto"
  std::optional<double> given_static_friction;
  double well_width = unset;  ///< [L]
  double tolerance = 1e-7;    ///< [grain weights]
  double gravity_ramp = 0.0;  ///< [T]
  std::string algorithm = "direct";
  double relaxation = 0.8;
  std::optional<bool> pin_base;
  std::optional<bool> relax;
  double skin = unset;  ///< [L]

  MethodTraits traits() const override { return {.impulse_laws = true, .collides = true, .typical_speed = 1e5}; }
  void keys(const Scene& scene, Parameters& keys) override {
    const double d = scene.grains.diameter;
    keys.optional_number("method.time_step", step,
                         {"auto", "2 (m / stiffness)^(1/2): 0.02 (d/g)^(1/2) at the usual one"}, positive, "T",
                         "length of a step; collisions lie anywhere within it");
    keys.optional_number("method.stiffness", given_stiffness, {"auto", "1e4 m g / d"}, positive, "M/T^2",
                         "of soft contacts between grains, and with walls");
    keys.optional_number("method.damping", given_damping, {"auto", "(m stiffness)^(1/2), 0.71 of critical for a pair"},
                         not_negative, "M/T", "of soft contacts, along the normal");
    keys.optional_number("method.slip_drag", given_slip_drag, {"auto", "as method.damping"}, not_negative, "M/T",
                         "sliding friction of soft contacts: force over slip speed, at most contact.rolling_friction "
                         "times the normal force");
    keys.optional_number("method.static_friction", given_static_friction, {"", "contact.friction"}, not_negative, "",
                         "of soft contacts with walls: largest horizontal force of the well over the normal force");
    keys.number("method.well_width", well_width, {1e-3 * d, "0.001 d"}, positive, "L",
                "displacement at which the well of static friction at a wall breaks");
    keys.number("method.gravity_ramp", gravity_ramp, not_negative, "T",
                "gravity rises from 0 over this time, so that a pile built in place does not fall into its own weight");
    keys.flag("method.pin_base", pin_base, false, "grains that stand on a wall at the start keep their x while soft");
    keys.flag("method.relax", relax, false,
              "grains that touch at the start are brought to equilibrium before time begins");
    keys.choice("method.solver", algorithm, {"direct", "sweeps"},
                "Newton's method with a sparse factorisation, or block Gauss-Seidel with relaxation");
    keys.number("method.tolerance", tolerance, positive, "grain weights", "largest residual force of a grain");
    if (algorithm == "sweeps") {
      keys.number("method.relaxation", relaxation, {.low = 0.0, .high = 1.5, .low_allowed = false}, "",
                  "fraction of Newton's step that a sweep takes");
    }
    keys.number("method.skin", skin, {0.3 * d, "0.3 d"}, positive, "L", "extra reach of the list of near grains");
  }
  void check(const Scene& scene, Problems& problems) const override;
  double automatic_step(const Scene& scene) const override;
  double time_step(const Scene& scene) const override { return step ? *step : automatic_step(scene); }
  std::optional<RestingContacts> resting_contacts(const Scene& scene) const override {
    return RestingContacts{stiffness(scene), pin_base.value_or(false)};
  }
  std::string describe(const Scene& scene) const override;
  using MethodKind::make;
  std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const override;

  double stiffness(const Scene& scene) const;  ///< [M/T^2]
  double damping(const Scene& scene) const;    ///< [M/T]
  double slip_drag(const Scene& scene) const;  ///< [M/T]
  double static_friction(const Scene& scene) const;
};

}  // namespace repose
