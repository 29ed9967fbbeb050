// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace repose {

namespace {

/// A union-find structure over contacts.
class Union {
 public:
  explicit Union(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

using Places = std::unordered_map<std::int64_t, std::size_t>;

/// The axis of the largest eigenvalue of the sum of n n, in (-90, 90] degrees.
double axis_deg(double xx, double yy, double xy) {
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi;
  return angle > -90.0 ? angle : 90.0;  // rounding may put a vertical axis at -90
}

std::vector<std::size_t> strong_contacts(const Contacts<2>& contacts, double threshold) {
  const auto counts = [&](const Contact<2>& contact) {
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

/// Sets the number of a chain's grains, and the width and height of the box around their centres. Follows the contacts
/// from grain to grain, so that a chain may cross the sides of a periodic box.
void measure(Chain& chain, const std::vector<std::size_t>& members, const Grains<2>& grains,
             const Contacts<2>& contacts, const Places& place, const Box<2>& box) {
  std::map<std::int64_t, std::vector<std::int64_t>> partners;
  for (const auto k : members) {
    const auto& contact = contacts.list[k];
    auto& list = partners[contact.first];
    if (contact.second < 0) continue;
    list.push_back(contact.second);
    partners[contact.second].push_back(contact.first);
  }
  const auto where = [&](std::int64_t id) { return grains.line[place.at(id)].position; };
  std::map<std::int64_t, Vec<2>> centre;  // relative to the first grain
  std::vector<std::int64_t> ahead{partners.begin()->first};
  centre[ahead.front()] = {};
  Vec<2> low{};
  Vec<2> high{};
  while (!ahead.empty()) {
    const auto id = ahead.back();
    ahead.pop_back();
    for (const auto partner : partners[id]) {
      if (centre.contains(partner)) continue;
      const Vec<2> at = centre[id] + separation(where(partner), where(id), box);
      centre[partner] = at;
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
      ahead.push_back(partner);
    }
  }
  chain.grains = partners.size();
  chain.width = high[0] - low[0];
  chain.height = high[1] - low[1];
}

}  // namespace

Chains find_chains(const Grains<2>& grains, const Contacts<2>& contacts, double threshold, const Box<2>& box) {
  Places place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], k);
  const auto strong = strong_contacts(contacts, threshold);
  Union sets(strong.size());
  std::unordered_map<std::int64_t, std::size_t> first_at;  // the first strong contact of each moving grain
  for (std::size_t s = 0; s < strong.size(); ++s) {
    const auto& contact = contacts.list[strong[s]];
    for (const auto id : {contact.first, contact.second}) {
      if (id < 0 || grains.line[place.at(id)].fixed()) continue;
      const auto [entry, is_new] = first_at.emplace(id, s);
      if (!is_new) sets.join(entry->second, s);
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> members;  // contacts of each set; a set is named by its first
  for (std::size_t s = 0; s < strong.size(); ++s) members[sets.find(s)].push_back(strong[s]);
  std::vector<const std::vector<std::size_t>*> order;
  for (const auto& [set, list] : members) order.push_back(&list);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->size() > b->size(); });

  Chains chains;
  chains.chain_of_contact.assign(contacts.list.size(), -1);
  for (const auto* list : order) {
    Chain chain;
    chain.contacts = list->size();
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
    for (const auto k : *list) {
      const auto& n = contacts.list[k].normal;
      xx += n[0] * n[0];
      yy += n[1] * n[1];
      xy += n[0] * n[1];
      chains.chain_of_contact[k] = static_cast<std::int64_t>(chains.list.size());
    }
    chain.direction_deg = axis_deg(xx, yy, xy);
    measure(chain, *list, grains, contacts, place, box);
    chains.list.push_back(chain);
  }
  return chains;
}

}  // namespace repose
