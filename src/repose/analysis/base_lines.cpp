// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/base_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace repose {

namespace {

/// A line from one end along its length.
struct Line {
  Vec<2> from{};
  Vec<2> along{};
  std::size_t last = 0;  // grain at its other end
};

bool continues(const Line& line, std::size_t first, const Vec<2>& along) {
  constexpr double same_direction = 1e-9;
  const double turn = line.along[0] * along[1] - line.along[1] * along[0];
  return line.last == first && dot(line.along, along) > 0.0 &&
         std::fabs(turn) <= same_direction * magnitude(line.along) * magnitude(along);
}

}  // namespace

std::vector<FlatWall> base_lines(const OrderedGrains<2>& grains, const Box<2>& box) {
  struct Disc {
    Vec<2> position;
    double radius;
  };
  std::vector<Disc> fixed;
  double smallest = std::numeric_limits<double>::infinity();  // [L] diameter of a grain that moves
  double largest = 0.0;                                       // [L] radius of a fixed grain
  for (const auto& grain : grains->line) {
    if (grain.fixed()) {
      fixed.push_back({grain.position, grain.radius});
      largest = std::max(largest, grain.radius);
    } else {
      smallest = std::min(smallest, 2.0 * grain.radius);
    }
  }
  if (!std::isfinite(smallest)) return {};
  std::sort(fixed.begin(), fixed.end(), [](const auto& a, const auto& b) {
    return a.position[0] != b.position[0] ? a.position[0] < b.position[0] : a.position[1] < b.position[1];
  });
  constexpr double rounding = 1e-9;  // a gap as wide as the grain lets it pass
  const double passable = smallest * (1.0 - rounding);
  const double reach = 2.0 * largest + smallest;
  std::vector<Line> lines;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    for (std::size_t n = i + 1; n < i + fixed.size(); ++n) {
      const bool around = n >= fixed.size();
      if (around && !box.periodic) break;
      const auto j = n % fixed.size();
      const double ahead = fixed[j].position[0] - fixed[i].position[0] + (around ? box.width() : 0.0);
      if (ahead > reach) break;
      const Vec<2> along = separation(fixed[j].position, fixed[i].position, box);
      if (magnitude(along) - fixed[i].radius - fixed[j].radius >= passable) continue;
      if (!lines.empty() && continues(lines.back(), i, along)) {
        lines.back().along += along;
        lines.back().last = j;
      } else {
        lines.push_back({fixed[i].position, along, j});
      }
    }
  }
  std::vector<FlatWall> walls;
  for (const auto& [from, along, last] : lines) {
    const double length = magnitude(along);
    if (!(length > 0.0)) continue;
    walls.push_back({from + along * 0.5, Vec<2>{{-along[1], along[0]}} * (1.0 / length), 0.5 * length});
  }
  return walls;
}

}  // namespace repose
