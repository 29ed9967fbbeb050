// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Rigid grains, whose contacts have impulses.
struct ContactDynamicsMethod final : KindOf<ContactDynamicsMethod, MethodKind> {
  static constexpr std::string_view kind = "contact-dynamics";
  static constexpr std::string_view meaning = "as rigid grains, by impulses";

  std::optional<double> step;             ///< [T]; none: "auto"
  std::optional<double> rolling_angle;    ///< [deg] the critical angle of deposition as a law of rolling
  std::optional<double> fastest;          ///< [L/T] limit of free velocities; none: "auto"
  std::string algorithm = "accelerated";  ///< or "sweeps"
  SolverLimits limits;
  std::string warm_start = "always";
  double overlap_recovery = 0.05;  ///< fraction of an overlap that a step takes back
  double skin = unset;             ///< [L]

  MethodTraits traits() const override {
    // A step ends with gaps of the size of its residual.
    return {.impulse_laws = true, .contact_gap = 5e-4, .typical_speed = 1e5};
  }
  void keys(const Scene& scene, Parameters& keys) override {
    keys.optional_number(
        "method.time_step", step, {"auto", ""}, positive, "T",
        "\"auto\": g dt^2 is a tenth of the smallest radius, and no grain falls half a radius in a step");
    keys.optional_number("method.critical_angle", rolling_angle, {"", "none"}, {.low = 0.0, .high = 90.0}, "deg",
                         "theta_c as a law of contacts: rolling friction tan(theta_c), infinite at 90, and no sliding");
    keys.optional_number(
        "method.speed_limit", fastest, {"auto", ""}, positive, "L/T",
        "no grain is faster before it meets others; \"auto\": g dt for a sequential source, else none");
    keys.choice("method.solver", algorithm, {"accelerated", "sweeps"},
                "conjugate residuals over symmetric sweeps of nonlinear Gauss-Seidel, or the sweeps alone");
    keys.number("method.tolerance", limits.tolerance, positive, "g dt",
                "largest residual velocity of a contact; the true residual, computed apart from the solver");
    keys.integer("method.most_sweeps", limits.most_sweeps, {.low = 1},
                 "sweeps forward and backward before a step is given up");
    keys.choice("method.unconverged", limits.unconverged, {"warn", "error"},
                "steps that are given up are counted and reported, or stop the run");
    keys.choice(
        "method.warm_start", warm_start, {"always", "settled", "never"},
        "contacts that start from their impulses of the step before: all; those of grains slower than 0.1 g dt, "
        "so that no impulse of an impact stays; none");
    keys.number("method.overlap_recovery", overlap_recovery, zero_to_one, "",
                "fraction of an overlap that a step takes back");
    keys.number("method.skin", skin, {0.3 * scene.grains.diameter, "0.3 d"}, positive, "L",
                "extra reach of the pair list; changes speed, never results beyond rounding");
  }
  void check(const Scene& scene, Problems& problems) const override;
  double automatic_step(const Scene& scene) const override;
  double time_step(const Scene& scene) const override { return step ? *step : automatic_step(scene); }
  std::optional<double> speed_limit(const Scene& scene) const override;
  std::optional<double> usual_rolling_angle() const override { return rolling_angle; }
  const SolverLimits* solver() const override { return &limits; }
  std::string describe(const Scene& scene) const override;
  bool in_dimension(std::int64_t) const override { return true; }
  std::unique_ptr<Method<2>> make(const Scene& scene, Dimension<2>) const override;
  std::unique_ptr<Method<3>> make(const Scene& scene, Dimension<3>) const override;
};

}  // namespace repose
