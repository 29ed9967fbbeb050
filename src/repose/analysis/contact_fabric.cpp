// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_fabric.hpp"

#include <cmath>
#include <vector>

namespace repose {

namespace {

template <class Counts>
std::optional<SpaceFabric> fabric_of(const std::vector<const Contact<3>*>& contacts, const Counts& counts) {
  SpaceFabric fabric;
  for (const auto* contact : contacts) {
    if (!counts(*contact)) continue;
    ++fabric.contacts;
    fabric.tensor.add_square(contact->normal);
  }
  if (fabric.contacts == 0) return std::nullopt;
  fabric.tensor *= 1.0 / static_cast<double>(fabric.contacts);
  fabric.principal = principal_axes(fabric.tensor);
  fabric.deviator = deviator(fabric.tensor);
  fabric.inclination_deg = inclination_deg(fabric.principal.axis[0]);
  return fabric;
}

}  // namespace

std::optional<ContactFabric> measure_contact_fabric(const Contacts<3>& contacts, double threshold, bool with_walls) {
  std::vector<const Contact<3>*> counting;
  double sum = 0.0;
  for (const auto& contact : contacts.list) {
    if (!(contact.normal_force > threshold) || !std::isfinite(contact.normal_force)) continue;
    if (contact.second < 0 && !with_walls) continue;
    counting.push_back(&contact);
    sum += contact.normal_force;
  }
  if (counting.empty()) return std::nullopt;
  const auto count = static_cast<double>(counting.size());
  ContactFabric fabric;
  fabric.mean_force = sum / count;
  const auto is_strong = [&](const Contact<3>& contact) { return contact.normal_force * count > sum; };  // find_chains
  fabric.all = *fabric_of(counting, [](const Contact<3>&) { return true; });
  fabric.strong = fabric_of(counting, is_strong);
  fabric.weak = fabric_of(counting, [&](const Contact<3>& contact) { return !is_strong(contact); });
  return fabric;
}

}  // namespace repose
