// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/methods/soft.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/laws/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// Four digits of x > 0, rounded down.
double rounded_down(double x) {
  const double digit = reproducible::pow(10.0, std::floor(reproducible::log(x) / std::numbers::ln10) - 3.0);
  return std::floor(x / digit) * digit;
}

}  // namespace

double SoftMethod::automatic_step(const Scene& scene) const {
  return std::min(auto_phase / scene.contact_frequency(), auto_part_of_bed * scene.largest_step_of_bed());
}

bool SoftMethod::synchronised(const Scene& scene) const {
  if (velocities != "auto") return velocities == "synchronised";
  return scene.largest_diameter() / scene.smallest_diameter() > synchronised_above_ratio;
}

/// The explicit step against the stiffest contact; only where all that it depends on is sound.
void SoftMethod::check(const Scene& scene, Problems& problems) const {
  if (!problems.none()) return;
  const double frequency = scene.contact_frequency();
  const double automatic = automatic_step(scene);
  if (!step) {
    if (std::isfinite(automatic) && automatic > 0.0) return;
    return problems.problem("method.time_step",
                            fmt::format(" = \"auto\": finds no step: the stiffest contact has the frequency w = {:.4g};"
                                        " give a step [T], or check stiffness, mass and diameter",
                                        frequency));
  }
  if (*step * frequency <= largest_phase) return;
  problems.problem(
      "method.time_step",
      fmt::format(" = {}: unstable: the stiffest contact (a fall from the source) has the frequency w = {:.4g}"
                  " and w dt = {:.3g} > 1; the largest step that is not refused is {:.4g}, \"auto\" takes "
                  "{:.4g} [T]",
                  *step, frequency, *step * frequency, rounded_down(largest_phase / frequency), automatic));
}

std::string SoftMethod::describe(const Scene& scene) const {
  const double dt = time_step(scene);
  std::string text = describe_force_laws(scene);
  text += fmt::format(
      "time step        {:.6g} ({}; w dt = {:.3g} for the stiffest contact of a fall from the source; {:.3g} of the "
      "largest for a dense bed)\n",
      dt, step ? "given" : "auto", dt * scene.contact_frequency(), dt / scene.largest_step_of_bed());
  const double ratio = scene.largest_diameter() / scene.smallest_diameter();
  text += fmt::format("velocities       {}{}\n", synchronised(scene) ? "synchronised" : "half-step",
                      velocities == "auto" ? fmt::format(" (auto; size ratio {:.3g})", ratio) : "");
  if (local_damping > 0.0) {
    text += fmt::format("global damping   local, {:g}: grains in flight fall at {:g} of gravity\n", local_damping,
                        1.0 - local_damping);
  }
  if (viscous_damping > 0.0) {
    text += fmt::format("global damping   viscous, {:g}: grains in flight fall no faster than {:.4g}\n",
                        viscous_damping, scene.gravity / viscous_damping);
  }
  return text;
}

}  // namespace repose
