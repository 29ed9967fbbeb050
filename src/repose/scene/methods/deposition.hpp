// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Discs or spheres dropped one by one, each sticking or rolling by the rule of the critical angle.
struct DepositionMethod final : KindOf<DepositionMethod, MethodKind> {
  static constexpr std::string_view kind = "deposition";
  static constexpr std::string_view meaning = "dropped one by one by the critical-angle rule";

  double critical_angle = unset;    ///< [deg]
  std::string arithmetic = "auto";  ///< or "snapped", "double"

  MethodTraits traits() const override { return {.follows_time = false, .typical_speed = 2e6}; }
  bool in_dimension(std::int64_t) const override { return true; }
  void keys(const Scene& scene, Parameters& keys) override {
    keys.number("method.critical_angle", critical_angle, required, {.low = 0.0, .high = 90.0}, "deg",
                "a disc sticks where its contact is less than this off upright: 0 steepest descent, 90 first touch");
    if (scene.dimension == 3) return;
    keys.choice(
        "method.arithmetic", arithmetic, {"auto", "snapped", "double"},
        "snapped: places are multiples of 2^-40 radii, so that rounding cannot grow from layer to layer (auto: at "
        "exactly 0 degrees)");
  }
  void check(const Scene& scene, Problems& problems) const override;
  double automatic_step(const Scene&) const override { return 1.0; }  // time counts discs
  double time_step(const Scene&) const override { return 1.0; }
  std::optional<double> sticking_angle() const override { return critical_angle; }
  std::string describe(const Scene& scene) const override;
  std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const override;
  std::unique_ptr<Method<3>> make(const Scene& scene, Dimension<3>) const override;

  /// Whether places are snapped: where asked for, and at exactly 0 degrees unless asked not to.
  bool snaps() const { return arithmetic == "snapped" || (arithmetic == "auto" && critical_angle == 0.0); }
};

}  // namespace repose
