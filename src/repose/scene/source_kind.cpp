// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/source_kind.hpp"

#include "repose/core/reproducible_math.hpp"
#include "repose/scene/scene.hpp"

#include <algorithm>
#include <cmath>

namespace repose {

double SourceKind::fall(const Scene& scene) const { return scene.usual_diameter(); }

double SourceKind::column(const Scene& scene) const {
  // N grains in a triangle of height h and slope 30 degrees: N = h^2 sqrt(3) / 0.9 (a core of discs at 0.8).
  const auto grains = static_cast<double>(released() + scene.start.moving);
  // In a cone of that slope N pi / 6 = 0.6 pi h^3, of spheres at 0.6.
  if (scene.dimension == 3) return std::max(1.0, reproducible::pow(grains / 3.6, 1.0 / 3.0));
  return std::max(1.0, std::sqrt(grains * 0.9 / std::sqrt(3.0)));
}

double SourceKind::expected_end(const Scene& scene) const {
  return 100.0 * std::sqrt(scene.grains.diameter / std::max(scene.gravity, 1e-30));
}

double SourceKind::expected_work(const Scene&, double) const { return 0.0; }

}  // namespace repose
