// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

void check_boundaries(const Scene& scene, Reader& reader) {
  const double d = scene.grains.diameter;
  constexpr double most_base_grains = 1e7;
  const double row = scene.box.x == "periodic" ? scene.box.half_width : scene.base.half_width;
  if (scene.base.kind == "row" && 2.0 * row / scene.base.spacing > most_base_grains && reader.sound("base.spacing") &&
      reader.sound("base.half_width")) {
    reader.problem("base.spacing",
                   fmt::format(" = {}: the row of half-width {} would have {:.3g} grains; at most {:g}",
                               scene.base.spacing, row, 2.0 * row / scene.base.spacing, most_base_grains));
  }
  if (scene.box.x == "periodic" && reader.sound("box.half_width")) {
    if (scene.box.half_width < 4.0 * scene.largest_diameter()) {
      reader.problem("box.half_width",
                     fmt::format(" = {}: a periodic box must be at least 8 diameters wide", scene.box.half_width));
    }
    const double discs = 2.0 * scene.box.half_width / scene.base.spacing;
    if (scene.base.kind == "row" && reader.sound("base.spacing") &&
        std::fabs(discs - std::round(discs)) > 1e-9 * discs) {
      reader.problem("base.spacing",
                     fmt::format(" = {}: must divide the width {} of the periodic box into whole spacings",
                                 scene.base.spacing, 2.0 * scene.box.half_width));
    }
  } else if (scene.base.kind == "row" && reader.sound("base.half_width") && reader.sound("box.half_width") &&
             scene.box.half_width < scene.base.half_width) {
    reader.problem("box.half_width", fmt::format(" = {}: must be at least base.half_width = {}", scene.box.half_width,
                                                 scene.base.half_width));
  }
  if (scene.base.kind == "row" && reader.sound("base.spacing") && reader.sound("grains.diameter") &&
      scene.base.spacing >= 2.0 * d) {
    reader.problem("base.spacing",
                   fmt::format(" = {}: must be < {}, two diameters, or grains fall through the base [L]",
                               scene.base.spacing, 2.0 * d));
  }
  for (std::size_t k = 0; k < scene.planes.size(); ++k) {
    const auto& [x, y] = scene.planes[k].normal;
    const auto key = fmt::format("plane[{}].normal", k);
    if (std::hypot(x, y) < 1e-100 && reader.sound(key)) {
      reader.problem(key, fmt::format(" = [{}, {}]: must have a direction", x, y));
    }
  }
}

}  // namespace repose
