// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/row.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

void RowBase::check(const Scene& scene, Problems& problems) const {
  if (!problems.sound("base.spacing")) return;
  const bool periodic = scene.box.periodic();
  const double half = periodic ? scene.box.half_width : half_width;
  if (2.0 * half / spacing > most_base_grains && problems.sound("base.half_width")) {
    problems.problem("base.spacing",
                     fmt::format(" = {}: the row of half-width {} would have {:.3g} grains; at most {:g}", spacing,
                                 half, 2.0 * half / spacing, most_base_grains));
  }
  const double discs = 2.0 * scene.box.half_width / spacing;
  if (periodic && problems.sound("box.half_width") && std::fabs(discs - std::round(discs)) > 1e-9 * discs) {
    problems.problem("base.spacing", fmt::format(" = {}: must divide the width {} of the periodic box into whole "
                                                 "spacings",
                                                 spacing, 2.0 * scene.box.half_width));
  }
  const double d = scene.grains.diameter;
  const double through = d + (scene.species.empty() ? d : scene.smallest_drawn());
  if (problems.sound("grains.diameter") && spacing >= through) {
    problems.problem(
        "base.spacing",
        fmt::format(" = {}: must be < {}, {}, or grains fall through the base [L]", spacing, through,
                    scene.species.empty() ? "two diameters" : "a diameter and that of the smallest grain"));
  }
}

double RowBase::height_on_top(const Scene& scene, double diameter) const {
  return 0.5 * (scene.grains.diameter + diameter);
}

std::string RowBase::describe() const { return fmt::format("row, spacing {:g}, half-width {:g}", spacing, half_width); }

}  // namespace repose
