// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/bed.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace repose {

void BedBase::check(const Scene& scene, Problems& problems) const {
  if (!problems.sound("base.spacing") || !problems.sound("base.radius")) return;
  const double grains = std::numbers::pi * (radius * radius) / (0.5 * std::sqrt(3.0) * (spacing * spacing));
  if (grains > most_base_grains) {
    problems.problem("base.spacing", fmt::format(" = {}: the base of radius {} would have {:.3g} grains; at most {:g}",
                                                 spacing, radius, grains, most_base_grains));
  }
  if (scene.box.periodic() || scene.box.periodic_y()) {
    problems.problem("base.kind", " = \"bed\": is round; a periodic box needs another base");
  }
  // Three spheres of a triangle with the side s let a grain through whose centre is s/sqrt(3) from each of theirs.
  const double d = scene.grains.diameter;
  const double smallest = scene.species.empty() ? d : scene.smallest_drawn();
  const double widest = spacing + 2.0 * std::sqrt(2.0) * disorder;
  if (widest < 0.5 * std::sqrt(3.0) * (d + smallest)) return;
  problems.problem(disorder > 0.0 ? "base.disorder" : "base.spacing",
                   fmt::format(" = {}: neighbours may be {:.4g} apart, and grains fall through the base from {:.4g} on "
                               "[L]",
                               disorder > 0.0 ? disorder : spacing, widest, 0.5 * std::sqrt(3.0) * (d + smallest)));
}

double BedBase::height_on_top(const Scene& scene, double diameter) const {
  return 0.5 * (scene.grains.diameter + diameter);
}

std::string BedBase::describe() const {
  return fmt::format("bed of spheres, spacing {:g}, radius {:g}, disorder {:g}, roughness {:g}", spacing, radius,
                     disorder, roughness);
}

}  // namespace repose
