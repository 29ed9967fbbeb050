// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace repose {

/// One contact as every method reports it. The normal points from the second to the first partner, the tangent of 2D is
/// the normal turned by +90 degrees, forces act on the first partner, a positive normal force pushes apart.
template <int D>
struct Contact {
  std::int64_t first = 0;   ///< id of a grain
  std::int64_t second = 0;  ///< id of a grain, or -1 - k for plane k
  Vec<D> normal{};
  double overlap = 0.0;           ///< [L] sum of the radii less the distance; negative in the tail of a long-ranged law
  double relative_overlap = 0.0;  ///< overlap over the mean diameter of the pair
  double normal_force = 0.0;      ///< [M L/T^2]
  Tangent<D> tangential_force{};  ///< [M L/T^2]
  Tangent<D> history{};           ///< [L] accumulated tangential displacement
  double first_lever = 0.0;       ///< [L] from the centre of the first partner to the contact point
  bool sliding = false;           ///< at the Coulomb limit
};

/// Force on the first partner [M L/T^2]; the second feels the opposite.
template <int D>
Vec<D> force_of(const Contact<D>& contact) {
  return contact.normal * contact.normal_force + in_space(contact.tangential_force, contact.normal);
}

constexpr std::int64_t plane_partner(std::int64_t plane) { return -1 - plane; }

/// The contacts of one moment: the output of every method, ordered by the ids of the partners.
template <int D>
struct Contacts {
  std::vector<Contact<D>> list;

  std::size_t size() const { return list.size(); }
  void sort() {
    const auto before = [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    };
    if (!std::is_sorted(list.begin(), list.end(), before)) std::sort(list.begin(), list.end(), before);
  }
};

}  // namespace repose
