// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

/// Steps of contact dynamics are stable at any length: what a step must not do is to miss what grains meet on their
/// way, or to let them fall past each other.
void check_step(const Scene& scene, Reader& reader) {
  const double step = scene.time_step();
  if (!scene.method.time_step && !(std::isfinite(step) && step > 0.0)) {
    return reader.problem(
        "method.time_step",
        " = \"auto\": finds no step where neither gravity nor a velocity gives a time: give a step [T]");
  }
  const double radius = 0.5 * scene.smallest_diameter();
  const auto limit = scene.speed_limit();
  const double fall = scene.fastest_fall();
  const double speed = limit && *limit < fall ? *limit : fall;
  if (speed * step <= radius && scene.gravity * step * step <= radius) return;
  const auto* key = scene.method.time_step ? "method.time_step" : "method.speed_limit";
  reader.problem(key,
                 fmt::format(": with the time step {:.4g} a grain at {:.4g}, by its fall or method.speed_limit, goes "
                             "{:.3g} radii of the smallest grain in a step; at most 1",
                             step, speed, std::max(speed, scene.gravity * step) * step / radius));
}

}  // namespace

void check_rigid(const Scene& scene, Reader& reader) {
  if (scene.source.kind == "sequential" && scene.gravity == 0.0 && reader.sound("gravity")) {
    reader.problem("source.kind", " = \"sequential\": needs gravity > 0");
  }
  if (scene.source.kind == "sequential" && reader.sound("source.half_width") && reader.sound("box.half_width") &&
      std::fabs(scene.source.x) + scene.source.half_width > scene.box.half_width) {
    reader.problem("source.half_width", fmt::format(" = {}: grains must be released within the box, x = +-{}",
                                                    scene.source.half_width, scene.box.half_width));
  }
  if (reader.problems().empty()) check_step(scene, reader);
}

}  // namespace repose
