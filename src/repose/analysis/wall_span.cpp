// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/wall_span.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace repose {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Places along a plane, from its point.
struct Interval {
  double low = -infinite;
  double high = infinite;
};

/// What the other planes leave of a plane.
Interval between_planes(const std::vector<FlatWall>& walls, std::size_t plane) {
  constexpr double parallel = 1e-9;
  Interval left;
  const Vec<2> along = along_wall(walls[plane].normal);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (w == plane || std::isfinite(walls[w].half_length)) continue;
    const double rise = dot(along, walls[w].normal);
    if (std::fabs(rise) < parallel) continue;
    const double place = dot(walls[w].point - walls[plane].point, walls[w].normal) / rise;
    if (rise > 0.0) left.low = std::max(left.low, place);
    if (rise < 0.0) left.high = std::min(left.high, place);
  }
  return left;
}

Interval reach_of(const Grains<2>& grains, const FlatWall& plane) {
  Interval reach{infinite, -infinite};
  for (const auto& grain : grains.line) {
    const double place = dot(grain.position - plane.point, along_wall(plane.normal));
    if (grain.fixed() || !std::isfinite(place)) continue;
    reach.low = std::min(reach.low, place - grain.radius);
    reach.high = std::max(reach.high, place + grain.radius);
  }
  return reach;
}

}  // namespace

std::vector<WallSpan> wall_spans(const std::vector<FlatWall>& walls, const Grains<2>& grains, const Box<2>& box) {
  std::vector<WallSpan> spans;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const auto& wall = walls[w];
    if (std::isfinite(wall.half_length)) {
      spans.push_back({wall.point, 2.0 * wall.half_length});
      continue;
    }
    if (box.periodic) {
      spans.push_back({{{0.5 * (box.x_min + box.x_max), wall.point[1]}}, box.width()});
      continue;
    }
    auto span = between_planes(walls, w);
    if (!std::isfinite(span.low) || !std::isfinite(span.high)) {
      const auto reach = reach_of(grains, wall);
      if (!std::isfinite(span.low)) span.low = reach.low;
      if (!std::isfinite(span.high)) span.high = reach.high;
    }
    const double length = span.high - span.low;
    if (!(length > 0.0) || !std::isfinite(length)) {
      spans.push_back({wall.point, 0.0});
      continue;
    }
    spans.push_back({wall.point + along_wall(wall.normal) * (0.5 * (span.low + span.high)), length});
  }
  return spans;
}

std::vector<double> wall_moments(const std::vector<WallSpan>& spans, const Grains<2>& grains,
                                 const Contacts<2>& contacts, const Box<2>& box) {
  std::vector<double> moments(spans.size(), 0.0);
  std::unordered_map<std::int64_t, std::size_t> place;
  for (std::size_t k = 0; k < grains.size() && !spans.empty(); ++k) place.emplace(grains.id[k], k);
  for (const auto& contact : contacts.list) {
    if (contact.second >= 0) continue;
    const auto wall = static_cast<std::size_t>(-1 - contact.second);
    const auto& grain = grains.line[place.at(contact.first)];
    const Vec<2> lever = separation(grain.position, spans[wall].middle, box) - contact.normal * contact.first_lever;
    const Vec<2> force = force_of(contact);
    moments[wall] -= lever[0] * force[1] - lever[1] * force[0];
  }
  return moments;
}

}  // namespace repose
