// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Forces from overlaps, explicit steps.
struct SoftMethod final : KindOf<SoftMethod, MethodKind> {
  static constexpr std::string_view kind = "soft";
  static constexpr std::string_view meaning = "by forces between grains that overlap";

  std::optional<double> step;       ///< [T]; none: "auto"
  std::string velocities = "auto";  ///< or "half-step", "synchronised"
  double skin = unset;              ///< [L]
  double local_damping = 0.0;
  double viscous_damping = 0.0;  ///< [1/T]

  MethodTraits traits() const override { return {.force_laws = true, .keeps_energy = true}; }
  void keys(const Scene& scene, Parameters& keys) override {
    keys.optional_number("method.time_step", step, {"auto", ""}, positive, "T",
                         "\"auto\": half a radian of the stiffest contact, and with which a dense bed comes to rest");
    keys.choice(
        "method.velocities", velocities, {"auto", "half-step", "synchronised"},
        "velocities in forces: of the half step, or predicted for the full one (auto: for size ratios above 2)");
    keys.number("method.skin", skin, {0.3 * scene.grains.diameter, "0.3 d"}, positive, "L",
                "extra reach of the pair list; changes speed, never results beyond rounding");
    keys.number(
        "method.local_damping", local_damping, 0.0, fraction, "",
        "Cundall's: a net force is weaker by this fraction where it speeds a grain up, stronger where it brakes");
    keys.number("method.viscous_damping", viscous_damping, 0.0, not_negative, "1/T",
                "a force of minus this times mass and velocity on every grain, and a torque alike");
  }
  void check(const Scene& scene, Problems& problems) const override;
  double automatic_step(const Scene& scene) const override;
  double time_step(const Scene& scene) const override { return step ? *step : automatic_step(scene); }
  bool synchronised(const Scene& scene) const override;
  std::string describe(const Scene& scene) const override;
  bool in_dimension(std::int64_t) const override { return true; }
  std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const override;
  std::unique_ptr<Method<3>> make(const Scene& scene, Dimension<3>) const override;
};

/// Size ratio above which velocities are predicted for the full step unless the scene says otherwise.
inline constexpr double synchronised_above_ratio = 2.0;

}  // namespace repose
