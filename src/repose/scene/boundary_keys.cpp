// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

namespace repose {

void boundary_keys(Scene& scene, Keys& keys) {
  const double d = scene.grains.diameter;
  keys.choice("base.kind", scene.base.kind, "none", {"row", "plane", "none"},
              "what the heap stands on, at height 0: a row of fixed grains, a plane, or nothing");
  if (scene.base.kind == "row") {
    keys.number("base.spacing", scene.base.spacing, d, positive, "L", "between the centres, one of them at x = 0");
    keys.number("base.half_width", scene.base.half_width, required, positive, "L", "the row covers +- this");
  } else if (scene.base.kind == "plane") {
    keys.flag("base.smooth", scene.base.smooth, false,
              "no friction, and the height of the centre as distance (Baxter et al. 1997)");
  }
  keys.choice("box.x", scene.box.x, "open", {"open", "periodic"}, "grains that leave an open box are lost and counted");
  const double room = scene.base.kind == "row" ? scene.base.half_width : 200.0 * d;
  keys.number("box.half_width", scene.box.half_width, scene.box.x == "periodic" ? room : room + 20.0 * d, positive, "L",
              "x from -half_width to half_width");
  keys.tables(
      "plane",
      [&](std::size_t count) {
        if (count > 0) scene.planes.resize(count);
        return scene.planes.size();
      },
      [&](const std::string& prefix, std::size_t k) {
        keys.vector(prefix + "point", scene.planes[k].point, std::nullopt, "L", "a point of the plane");
        keys.vector(prefix + "normal", scene.planes[k].normal, std::nullopt, "", "towards the grains");
        keys.flag(prefix + "smooth", scene.planes[k].smooth, false, "as base.smooth");
      });
}

}  // namespace repose
