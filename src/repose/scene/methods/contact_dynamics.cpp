// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/methods/contact_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose {

namespace {

/// While rigid grains rest and roll, only g dt^2 over a radius matters; in flight, the displacement in a step.
constexpr double largest_fall = 0.1;
constexpr double largest_displacement = 0.5;

}  // namespace

double ContactDynamicsMethod::automatic_step(const Scene& scene) const {
  const double radius = 0.5 * scene.smallest_diameter();
  const double by_fall =
      scene.gravity > 0.0 ? std::sqrt(largest_fall * radius / scene.gravity) : std::numeric_limits<double>::infinity();
  // A source that limits speeds lets no grain become faster than g dt.
  if (!fastest && scene.source->limits_speed()) return by_fall;
  const double speed = fastest ? std::min(*fastest, scene.fastest_fall()) : scene.fastest_fall();
  return std::min(by_fall, largest_displacement * radius / speed);
}

std::optional<double> ContactDynamicsMethod::speed_limit(const Scene& scene) const {
  if (fastest || !scene.source->limits_speed()) return fastest;
  return scene.gravity * time_step(scene);
}

/// Steps of contact dynamics are stable at any length. A step must not miss what grains meet on their paths, nor let
/// them fall past each other.
void ContactDynamicsMethod::check(const Scene& scene, Problems& problems) const {
  if (!problems.none()) return;
  const double dt = time_step(scene);
  if (!step && !(std::isfinite(dt) && dt > 0.0)) {
    return problems.problem(
        "method.time_step",
        " = \"auto\": finds no step where neither gravity nor a velocity gives a time: give a step [T]");
  }
  const double radius = 0.5 * scene.smallest_diameter();
  const auto limit = speed_limit(scene);
  const double fall = scene.fastest_fall();
  const double speed = limit && *limit < fall ? *limit : fall;
  if (speed * dt <= radius && scene.gravity * dt * dt <= radius) return;
  const auto* key = step ? "method.time_step" : "method.speed_limit";
  problems.problem(
      key, fmt::format(": with the time step {:.4g} a grain at speed {:.4g}, by its fall or method.speed_limit, moves "
                       "{:.3g} radii of the smallest grain in a step; at most 1",
                       dt, speed, std::max(speed, scene.gravity * dt) * dt / radius));
}

std::string ContactDynamicsMethod::describe(const Scene& scene) const {
  const double dt = time_step(scene);
  std::string text = describe_impulse_laws(scene);
  text += fmt::format("time step        {:.6g} ({}; g dt^2 = {:.3g} radii)\n", dt, step ? "given" : "auto",
                      scene.gravity * dt * dt / (0.5 * scene.smallest_diameter()));
  if (const auto limit = speed_limit(scene)) text += fmt::format("speed limit      {:.4g}\n", *limit);
  if (warm_start != "always") text += fmt::format("warm start       {}\n", warm_start);
  text += fmt::format("solver           {}, residual {:g} g dt, at most {} sweeps{}\n", algorithm, limits.tolerance,
                      limits.most_sweeps, limits.stops() ? " or stop" : "");
  return text;
}

}  // namespace repose
