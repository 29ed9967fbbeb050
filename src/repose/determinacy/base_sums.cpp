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

namespace {

const Vec<2> downward{{0.0, -1.0}};
const Vec<2> to_the_right{{1.0, 0.0}};

BaseSums sums_of_floor(const BaseProfile& recorded, const ContactProblem& posed) {
  std::unordered_map<std::int64_t, std::size_t> contact_of;  // a disc has one contact with a plane
  for (std::size_t k = 0; k < posed.problem.contacts.size(); ++k) {
    const auto& c = posed.problem.contacts[k];
    if (posed.places[c.second].id == wall_partner(base_wall)) contact_of.emplace(posed.places[c.first].id, k);
  }
  BaseSums sums;
  sums.id = recorded.id;
  sums.x = recorded.x;
  for (const auto id : recorded.id) {
    const auto contact = contact_of.at(id);
    const auto floor = posed.problem.contacts[contact].second;
    sums.normal.push_back({{force_on_body(posed.problem, contact, floor, downward)}});
    sums.shear.push_back({{force_on_body(posed.problem, contact, floor, to_the_right)}});
  }
  return sums;
}

}  // namespace

BaseSums base_sums(const Record<2>& record, const ContactProblem& posed) {
  if (record.scene.base->wall(record.scene)) return sums_of_floor(record.base, posed);
  std::unordered_map<std::int64_t, std::size_t> body;
  for (std::size_t k = 0; k < posed.places.size(); ++k) body.emplace(posed.places[k].id, k);
  BaseSums sums;
  const auto& grains = *record.grains;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!grains.base[k]) continue;
    const auto place = body.at(grains.id[k]);
    sums.id.push_back(grains.id[k]);
    sums.x.push_back(grains.line[k].position[0]);
    sums.normal.push_back(force_on_body(posed.problem, place, downward));
    sums.shear.push_back(force_on_body(posed.problem, place, to_the_right));
  }
  return sums;
}

}  // namespace repose
