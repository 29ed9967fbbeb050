// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/standing.hpp"

#include "repose/analysis/groups.hpp"

#include <cstdint>
#include <unordered_map>

namespace repose {

template <int D>
std::vector<bool> standing(const Grains<D>& grains, const Contacts<D>& contacts) {
  const auto ground = grains.size();  // the place of all walls and fixed grains
  std::unordered_map<std::int64_t, std::size_t> place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], grains.line[k].fixed() ? ground : k);
  Groups groups(grains.size() + 1);
  for (const auto& contact : contacts.list) {
    groups.join(place.at(contact.first), contact.second < 0 ? ground : place.at(contact.second));
  }
  std::vector<bool> found(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    found[k] = !grains.line[k].fixed() && groups.of(k) == groups.of(ground);
  }
  return found;
}

template std::vector<bool> standing(const Grains<2>&, const Contacts<2>&);
template std::vector<bool> standing(const Grains<3>&, const Contacts<3>&);

}  // namespace repose
