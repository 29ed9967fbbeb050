// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/vec.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace repose {

/// One contact, as every method reports it. The normal points from the second to the first partner; the tangent in 2D
/// is the normal turned by +90 degrees. Forces act on the first partner, and a positive normal force pushes it away.
template <int D>
struct Contact {
  std::int64_t first = 0;   ///< id of a grain
  std::int64_t second = 0;  ///< id of a grain, or -1 - k for wall k
  Vec<D> normal{};
  double overlap = 0.0;  ///< [L] sum of the radii minus the distance; negative beyond touching, in a long-ranged law
  double relative_overlap = 0.0;  ///< overlap divided by the mean diameter of the pair
  double normal_force = 0.0;      ///< [M L/T^2]
  Tangent<D> tangential_force{};  ///< [M L/T^2]
  Tangent<D> slip{};              ///< [L] slip displacement: tangential displacement accumulated by the contact
  Tangent<D> rolling{};           ///< [M L/T^2] torque on the first over the roll radius; twisting too
  double first_lever = 0.0;       ///< [L] from the centre of the first partner to the contact point
  bool sliding = false;           ///< at the Coulomb limit
};

/// Force on the first partner [M L/T^2]; the force on the second is its negative.
template <int D>
Vec<D> force_of(const Contact<D>& contact) {
  return contact.normal * contact.normal_force + in_space(contact.tangential_force, contact.normal);
}

/// The number by which a contact names wall k as its second partner.
constexpr std::int64_t wall_partner(std::int64_t wall) { return -1 - wall; }

/// The contacts at one time, in ascending order of the partners' ids once sorted. Every method reports them.
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

/// Contacts in their order, some at a time, so that not all of them need to be in memory at once.
template <int D>
struct ContactBlocks {
  using Use = std::function<void(const std::vector<Contact<D>>& block)>;

  std::size_t size = 0;  ///< of all blocks together
  /// Calls a function with block after block, none of them empty; with an empty one if there are no contacts.
  std::function<void(const Use&)> for_each;
};

/// A list as a single block. It refers to the list.
template <int D>
ContactBlocks<D> blocks_of(const Contacts<D>& contacts) {
  return {contacts.size(), [&contacts](const auto& use) { use(contacts.list); }};
}

/// The grains on which a grain came to rest, by their places in memory; negative where there is none.
struct SupportPair {
  std::int32_t first = -1;
  std::int32_t second = -1;
};

}  // namespace repose
