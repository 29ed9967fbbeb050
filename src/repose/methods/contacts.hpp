// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/grains.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The contact of two rigid grains (places in memory) before any force: partners, normal and overlap.
template <int D>
Contact<D> contact_of_grains(const Grains<D>& grains, std::size_t first, std::size_t second, const Box<D>& box) {
  const auto& a = grains.line[first];
  const auto& b = grains.line[second];
  const Vec<D> d = separation(a.position, b.position, box);
  const double distance = magnitude(d);
  Contact<D> contact;
  contact.first = grains.id[first];
  contact.second = grains.id[second];
  contact.normal = d * (1.0 / distance);
  contact.overlap = a.radius + b.radius - distance;
  contact.relative_overlap = contact.overlap / (a.radius + b.radius);
  contact.first_lever = a.radius;
  return contact;
}

/// The same for a grain and wall number `wall`, which is at `now`.
template <int D>
Contact<D> contact_with_wall(const Grains<D>& grains, std::size_t grain, const std::vector<Wall<D>>& walls,
                             std::size_t wall, const WallNow<D>& now, const Box<D>& box) {
  const auto& a = grains.line[grain];
  const auto place = above(walls[wall], now.normal, from_wall(walls[wall], now, a.position, box));
  Contact<D> contact;
  contact.first = grains.id[grain];
  contact.second = wall_partner(static_cast<std::int64_t>(wall));
  contact.normal = place.normal;
  contact.overlap = wall_overlap(walls[wall], place, a.radius);
  contact.relative_overlap = contact.overlap / (2.0 * a.radius);
  contact.first_lever = a.radius;
  return contact;
}

}  // namespace repose
