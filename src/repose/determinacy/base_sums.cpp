// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/determinacy/base_sums.hpp"

#include <unordered_map>

namespace repose {

BaseProfile BaseSums::profile(const ContactForces& forces) const {
  BaseProfile profile;
  profile.id = id;
  profile.x = x;
  for (const auto& sum : normal) profile.normal.push_back(sum(forces));
  for (const auto& sum : shear) profile.shear.push_back(sum(forces));
  return profile;
}

BaseSums base_sums(const Record& record, const ContactProblem& posed) {
  std::unordered_map<std::int64_t, std::size_t> body;
  for (std::size_t k = 0; k < posed.places.size(); ++k) body.emplace(posed.places[k].id, k);
  BaseSums sums;
  const auto& grains = *record.grains;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!grains.base[k]) continue;
    const auto place = body.at(grains.id[k]);
    sums.id.push_back(grains.id[k]);
    sums.x.push_back(grains.line[k].position[0]);
    sums.normal.push_back(force_on_body(posed.problem, place, {{0.0, -1.0}}));
    sums.shear.push_back(force_on_body(posed.problem, place, {{1.0, 0.0}}));
  }
  return sums;
}

}  // namespace repose
