// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace repose::hybrid {

/// A soft contact, as it lasts from step to step.
struct Touch {
  std::uint32_t grain = 0;    ///< index in memory; the lower one of two grains
  std::uint32_t armed = 0;    ///< 1: the static well at a wall holds
  std::int64_t partner = 0;   ///< index in memory of the other grain, or -1 - k for wall k
  double anchor = 0.0;        ///< [L] x0 of the well, along the tangent of the wall
  double normal_force = 0.0;  ///< [M L/T^2] mean of the last step
  double tangential_force = 0.0;
};

/// The contact of a grain and a partner, with the partners in their order.
inline Touch touch_between(std::uint32_t grain, std::int64_t partner) {
  Touch touch;
  touch.grain = grain;
  touch.partner = partner;
  if (partner >= 0 && partner < grain) {
    touch.grain = static_cast<std::uint32_t>(partner);
    touch.partner = grain;
  }
  return touch;
}

inline bool before(const Touch& a, const Touch& b) {
  return std::tie(a.grain, a.partner) < std::tie(b.grain, b.partner);
}

/// The soft contacts of a time, in ascending order of their partners.
struct Touches {
  std::vector<Touch> list;

  /// The touch of two partners; null if they have none.
  const Touch* find(std::uint32_t grain, std::int64_t partner) const {
    Touch wanted;
    wanted.grain = grain;
    wanted.partner = partner;
    const auto found = std::lower_bound(list.begin(), list.end(), wanted, before);
    const bool same = found != list.end() && found->grain == grain && found->partner == partner;
    return same ? &*found : nullptr;
  }
  void insert(const Touch& touch) {
    const auto place = std::lower_bound(list.begin(), list.end(), touch, before);
    if (place == list.end() || before(touch, *place)) list.insert(place, touch);
  }
};

}  // namespace repose::hybrid
