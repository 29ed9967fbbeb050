// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/counted.hpp"

#include <fmt/format.h>

namespace repose {

void CountedBase::count_key(Parameters& keys) {
  keys.integer("base.count", count, {.low = 2}, "width of base and box in diameters");
}

std::optional<double> CountedBase::box_half_width(const Scene& scene) const {
  return 0.5 * static_cast<double>(count) * scene.grains.diameter;
}

std::string CountedBase::width_text() const { return fmt::format("{} diameters wide", count); }

void CountedBase::check(const Scene& scene, Problems& problems) const {
  if (!problems.sound("base.count")) return;
  if (static_cast<double>(count) > most_base_grains) {
    problems.problem("base.count", fmt::format(" = {}: must be at most {:.0f}", count, most_base_grains));
  }
  const double half = *box_half_width(scene);
  if (!scene.method->traits().follows_time) {
    const double largest = scene.largest_drawn();
    if (half >= largest * (1.0 - 1e-9)) return;
    problems.problem("base.count",
                     fmt::format(" = {}: the width {:.4g} must be at least two of the largest diameters, {:.4g} [L]",
                                 count, 2.0 * half, 2.0 * largest));
  } else if (scene.box.periodic() && half < 4.0 * scene.largest_diameter()) {
    problems.problem("base.count",
                     fmt::format(" = {}: a periodic box must be at least 8 of the largest diameters wide", count));
  }
}

double ContiguousBase::height_on_top(const Scene& scene, double diameter) const {
  return 0.5 * (scene.grains.diameter + diameter);
}

}  // namespace repose
