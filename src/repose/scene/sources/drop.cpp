// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/sources/drop.hpp"

#include "repose/scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace repose {

void DropSource::check(const Scene& scene, Problems& problems) const {
  if (scene.gravity == 0.0 && problems.sound("gravity")) {
    problems.problem("source.kind", fmt::format(" = \"{}\": needs gravity > 0", name()));
  }
  if (problems.sound("source.half_width") && problems.sound("box.half_width") &&
      std::fabs(x) + half_width > scene.box.half_width) {
    problems.problem("source.half_width", fmt::format(" = {}: the opening must lie within the box, x = +-{}",
                                                      half_width, scene.box.half_width));
  }
  if (above_apex() || !problems.none()) return;
  if (const auto wall = wall_that_blocks(scene, x, half_width, height)) {
    problems.problem("source.height", fmt::format(" = {}: no grain ever finds room there: wall \"{}\" is in the way",
                                                  height, wall_names(scene)[*wall]));
  }
}

double DropSource::fall(const Scene& scene) const {
  // From above the highest grain of a heap, a grain may fall past the heap. No slope is steeper than 45 degrees for
  // long, so the lowest place is no farther below than the sides are away.
  const auto sides = upright_sides(scene);
  const double heap =
      std::min(scene.expected_column() * scene.grains.diameter, std::max(sides.right - x, x - sides.left));
  return height + (above_apex() ? heap : 0.0) + scene.rise(velocity);
}

double DropSource::expected_end(const Scene& scene) const {
  const double poured = static_cast<double>(count) / rate;
  return poured + std::sqrt(2.0 * height / scene.gravity) + 50.0 * std::sqrt(scene.grains.diameter / scene.gravity);
}

double DropSource::expected_work(const Scene&, double time) const {
  const double during = std::min(time, static_cast<double>(count) / rate);
  return 0.5 * rate * during * during + static_cast<double>(count) * (time - during);
}

Default PourSource::usual_half_width(const Scene& scene) const { return {3.0 * scene.grains.diameter, "3 d"}; }

Default RainSource::usual_half_width(const Scene& scene) const {
  return {scene.base->of_grains() ? scene.base->reach(scene) : scene.box.half_width, "all of the base or box"};
}

std::string PourSource::describe() const { return fmt::format("{} poured", count); }
std::string RainSource::describe() const { return fmt::format("{} rained", count); }

}  // namespace repose
