// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sticking_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace repose {

namespace {

/// The supports of a disc: the extreme directions from supports to the disc, which decide whether it rests.
class Supports {
 public:
  explicit Supports(double least_upright) : least_upright_(least_upright) {}

  void add(double x, double y) {
    sticks_ = sticks_ || y > least_upright_;
    // On either side the contact nearest to the vertical, with the largest y per x, carries most.
    if (x > 0.0) from_left_ = std::max(from_left_, y / x);
    if (x < 0.0) from_right_ = std::max(from_right_, -y / x);
    upright_ = upright_ || x == 0.0;
  }

  /// Two forces whose horizontal components cancel carry weight if their sum points up.
  bool rest() const { return sticks_ || upright_ || from_left_ + from_right_ > -1e-6; }

 private:
  double least_upright_;
  bool sticks_ = false;
  bool upright_ = false;
  double from_left_ = -std::numeric_limits<double>::infinity();
  double from_right_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<std::uint8_t> breaks_sticking_rule(const Discs& discs, const Box<2>& box, const ContactGraph& graph,
                                               const PackingWalls& walls, double gap, double critical_angle_deg,
                                               double slack_deg) {
  const double degree = std::numbers::pi / 180.0;
  const double least_upright = std::cos(std::min(90.0, critical_angle_deg + slack_deg) * degree);
  std::vector<std::uint8_t> breaks(discs.size(), 0);
  for (std::uint32_t k = 0; k < discs.size(); ++k) {
    if (discs.base[k]) continue;
    const auto& place = discs.position[k];
    const double touching = discs.radius[k] * (1.0 + 2.0 * gap);
    if (walls.floor && place[1] - *walls.floor < touching) continue;
    Supports supports(least_upright);
    for (const auto j : graph.of(k)) {
      if (j > k) break;  // deposited later; neighbours ascend
      const auto d = separation(place, discs.position[j], box);
      const double distance = magnitude(d);
      supports.add(d[0] / distance, d[1] / distance);
    }
    // A side wall pushes horizontally: it supports together with any contact from below on the other side.
    if (walls.left && place[0] - *walls.left < touching) supports.add(1.0, 0.0);
    if (walls.right && *walls.right - place[0] < touching) supports.add(-1.0, 0.0);
    breaks[k] = supports.rest() ? 0 : 1;
  }
  return breaks;
}

double deepest_overlap(const Discs& discs, const Box<2>& box, const ContactGraph& graph) {
  double deepest = 0.0;
  for (std::uint32_t i = 0; i < discs.size(); ++i) {
    for (const auto j : graph.of(i)) {
      if (j > i) break;
      const double reach = discs.radius[i] + discs.radius[j];
      const double distance = magnitude(separation(discs.position[i], discs.position[j], box));
      deepest = std::max(deepest, (reach - distance) / reach);
    }
  }
  return deepest;
}

}  // namespace repose
