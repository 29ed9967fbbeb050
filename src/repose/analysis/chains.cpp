// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/chains.hpp"

#include "repose/analysis/groups.hpp"
#include "repose/analysis/principal_axes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace repose {

namespace {

using Places = std::unordered_map<std::int64_t, std::size_t>;

/// The axis of the largest eigenvalue of the sum of n n, in (-90, 90] degrees.
double axis_deg(double xx, double yy, double xy) {
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi;
  return angle > -90.0 ? angle : 90.0;  // rounding may put a vertical axis at -90
}

double axis_of(const std::vector<std::size_t>& members, const Contacts<2>& contacts) {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (const auto k : members) {
    const auto& n = contacts.list[k].normal;
    xx += n[0] * n[0];
    yy += n[1] * n[1];
    xy += n[0] * n[1];
  }
  return axis_deg(xx, yy, xy);
}

double axis_of(const std::vector<std::size_t>& members, const Contacts<3>& contacts) {
  SymmetricTensor sum;
  for (const auto k : members) sum.add_square(contacts.list[k].normal);
  return inclination_deg(principal_axes(sum).axis[0]);
}

double width_of(const std::vector<Vec<2>>& centres) {
  const auto [low, high] =
      std::minmax_element(centres.begin(), centres.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  return (*high)[0] - (*low)[0];
}

/// The largest horizontal distance between two points, which are corners of their convex outline.
double width_of(std::vector<Vec<3>> centres) {
  std::sort(centres.begin(), centres.end(),
            [](const auto& a, const auto& b) { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; });
  const auto turns_left = [](const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0;
  };
  std::vector<Vec<3>> corners;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = corners.size();
    for (const auto& centre : centres) {
      while (corners.size() >= first + 2 && !turns_left(corners[corners.size() - 2], corners.back(), centre)) {
        corners.pop_back();
      }
      corners.push_back(centre);
    }
    std::reverse(centres.begin(), centres.end());
  }
  double farthest = 0.0;
  for (const auto& a : corners) {
    for (const auto& b : corners) farthest = std::max(farthest, std::hypot(a[0] - b[0], a[1] - b[1]));
  }
  return farthest;
}

template <int D>
std::vector<std::size_t> strong_contacts(const Contacts<D>& contacts, double threshold) {
  const auto counts = [&](const Contact<D>& contact) {
    return contact.normal_force > threshold && std::isfinite(contact.normal_force);
  };
  double sum = 0.0;
  double count = 0.0;
  for (const auto& contact : contacts.list) {
    if (!counts(contact)) continue;
    sum += contact.normal_force;
    count += 1.0;
  }
  std::vector<std::size_t> strong;
  for (std::size_t k = 0; k < contacts.list.size(); ++k) {
    const auto& contact = contacts.list[k];
    if (counts(contact) && contact.normal_force * count > sum) strong.push_back(k);
  }
  return strong;
}

/// Sets the number of a chain's grains, and the width and height of their centres. Follows the contacts from grain to
/// grain, so that a chain may cross the sides of a periodic box.
template <int D>
void measure(Chain& chain, const std::vector<std::size_t>& members, const Grains<D>& grains,
             const Contacts<D>& contacts, const Places& place, const Box<D>& box) {
  std::map<std::int64_t, std::vector<std::int64_t>> partners;
  for (const auto k : members) {
    const auto& contact = contacts.list[k];
    auto& list = partners[contact.first];
    if (contact.second < 0) continue;
    list.push_back(contact.second);
    partners[contact.second].push_back(contact.first);
  }
  const auto where = [&](std::int64_t id) { return grains.line[place.at(id)].position; };
  std::map<std::int64_t, Vec<D>> centre;  // relative to the first grain
  std::vector<std::int64_t> ahead{partners.begin()->first};
  centre[ahead.front()] = {};
  std::vector<Vec<D>> centres{Vec<D>{}};
  double low = 0.0;
  double high = 0.0;
  while (!ahead.empty()) {
    const auto id = ahead.back();
    ahead.pop_back();
    for (const auto partner : partners[id]) {
      if (centre.contains(partner)) continue;
      const Vec<D> at = centre[id] + separation(where(partner), where(id), box);
      centre[partner] = at;
      centres.push_back(at);
      low = std::min(low, at[up<D>]);
      high = std::max(high, at[up<D>]);
      ahead.push_back(partner);
    }
  }
  chain.grains = partners.size();
  chain.width = width_of(std::move(centres));
  chain.height = high - low;
}

}  // namespace

template <int D>
Chains find_chains(const Grains<D>& grains, const Contacts<D>& contacts, double threshold, const Box<D>& box) {
  Places place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], k);
  const auto strong = strong_contacts(contacts, threshold);
  Groups groups(strong.size());
  std::unordered_map<std::int64_t, std::size_t> first_at;  // the first strong contact of each moving grain
  for (std::size_t s = 0; s < strong.size(); ++s) {
    const auto& contact = contacts.list[strong[s]];
    for (const auto id : {contact.first, contact.second}) {
      if (id < 0 || grains.line[place.at(id)].fixed()) continue;
      const auto [entry, is_new] = first_at.emplace(id, s);
      if (!is_new) groups.join(entry->second, s);
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> members;  // contacts of each set; a set is named by its first
  for (std::size_t s = 0; s < strong.size(); ++s) members[groups.of(s)].push_back(strong[s]);
  std::vector<const std::vector<std::size_t>*> order;
  for (const auto& [set, list] : members) order.push_back(&list);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->size() > b->size(); });

  Chains chains;
  chains.chain_of_contact.assign(contacts.list.size(), -1);
  for (const auto* list : order) {
    Chain chain;
    chain.contacts = list->size();
    for (const auto k : *list) chains.chain_of_contact[k] = static_cast<std::int64_t>(chains.list.size());
    chain.direction_deg = axis_of(*list, contacts);
    measure(chain, *list, grains, contacts, place, box);
    chains.list.push_back(chain);
  }
  return chains;
}

template Chains find_chains(const Grains<2>&, const Contacts<2>&, double, const Box<2>&);
template Chains find_chains(const Grains<3>&, const Contacts<3>&, double, const Box<3>&);

}  // namespace repose
