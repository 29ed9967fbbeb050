// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/bare.hpp"

namespace repose {

std::optional<Wall<2>> PlaneBase::wall(const Scene& scene) const {
  Wall<2> wall{.point = {}, .normal = {{0.0, 1.0}}, .smooth = smooth};
  wall.material = scene.material_number(material);
  return wall;
}

}  // namespace repose
