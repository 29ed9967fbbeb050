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
  const auto place = above(walls[wall], now, from_wall(walls[wall], now, a.position, box));
  Contact<D> contact;
  contact.first = grains.id[grain];
  contact.second = wall_partner(static_cast<std::int64_t>(wall));
  contact.normal = place.normal;
  contact.overlap = wall_overlap(walls[wall], place, a.radius);
  contact.relative_overlap = contact.overlap / (2.0 * a.radius);
  contact.first_lever = a.radius;
  return contact;
}

/// The contacts that follow from what each grain came to rest on. They refer to the grains and the supports.
template <int D>
ContactBlocks<D> contacts_of_supports(const Grains<D>& grains, const std::vector<SupportPair>& supports,
                                      const Box<D>& box) {
  std::size_t count = 0;
  for (const auto& both : supports) count += (both.first >= 0 ? 1U : 0U) + (both.second >= 0 ? 1U : 0U);
  return {count, [&grains, &supports, box](const auto& use) {
            constexpr std::size_t most = 65536;
            std::vector<Contact<D>> block;
            for (std::size_t k = 0; k < supports.size(); ++k) {
              const auto [low, high] = std::minmax(supports[k].first, supports[k].second);
              for (const auto support : {low, high}) {
                if (support < 0) continue;
                if (block.size() == most) {
                  use(block);
                  block.clear();
                }
                block.push_back(contact_of_grains(grains, k, static_cast<std::size_t>(support), box));
              }
            }
            use(block);
          }};
}

}  // namespace repose
