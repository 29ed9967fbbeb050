// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/flat_wall.hpp"

#include <cmath>

namespace repose {

std::vector<PieceOfWall> pieces_near(const Vec<2>& point, const std::vector<FlatWall>& walls, const Box<2>& box,
                                     double unit, double reach) {
  std::vector<PieceOfWall> near;
  for (const auto& wall : walls) {
    if (!std::isfinite(wall.half_length)) continue;
    const Vec<2> along = Vec<2>{{wall.normal[1], -wall.normal[0]}} * wall.half_length;
    const Vec<2> nearest = separation(wall.point, point, box);
    const int images =
        box.periodic ? static_cast<int>(std::ceil((reach * unit + wall.half_length) / box.width() + 0.5)) : 0;
    for (int image = -images; image <= images; ++image) {
      Vec<2> middle = nearest;
      if (image != 0) middle[0] += image * box.width();
      const PieceOfWall piece{(middle - along) * (1.0 / unit), (middle + along) * (1.0 / unit)};
      if (distance_to(piece) < reach) near.push_back(piece);
    }
  }
  return near;
}

}  // namespace repose
