// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/base_forces.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace repose {

BaseProfile floor_profile(const Grains<2>& grains, const Contacts<2>& contacts, std::int64_t wall, double time,
                          double unit) {
  std::unordered_map<std::int64_t, double> place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], grains.line[k].position[0]);
  struct Carried {
    double x;
    std::int64_t id;
    Vec<2> force;  // of the wall
    bool operator<(const Carried& other) const { return std::tie(x, id) < std::tie(other.x, other.id); }
  };
  std::vector<Carried> carried;
  for (const auto& contact : contacts.list) {
    if (contact.second != wall_partner(wall) || !(contact.normal_force > 0.0)) continue;
    carried.push_back({place.at(contact.first), contact.first, force_of(contact)});
  }
  std::sort(carried.begin(), carried.end());
  BaseProfile profile;
  profile.window_start = time;
  profile.window_end = time;
  for (const auto& one : carried) {
    profile.id.push_back(one.id);
    profile.x.push_back(one.x);
    profile.normal.push_back(one.force[1] / unit);
    profile.shear.push_back(-one.force[0] / unit);
  }
  return profile;
}

BaseForces::BaseForces(const Grains<2>& grains, double window, double tolerance)
    : window_(window), tolerance_(tolerance) {
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (grains.line[k].fixed()) ids_.push_back(grains.id[k]);
  }
}

std::size_t BaseForces::place_of(std::int64_t id) const {
  return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

void BaseForces::record(Grains<2>& grains, double time) {
  Interval interval;
  interval.start = intervals_.empty() ? 0.0 : intervals_.back().end;
  interval.end = time;
  interval.impulse.resize(ids_.size());
  for (std::size_t k = 0; k < grains.reaction.size(); ++k) {
    if (!grains.line[k].fixed()) continue;
    interval.impulse[place_of(grains.id[k])] = grains.reaction[k];
    grains.reaction[k] = {};
  }
  intervals_.push_back(std::move(interval));
  while (intervals_.size() > 1 && intervals_[1].start <= time - window_ + tolerance_) intervals_.pop_front();
}

BaseProfile BaseForces::profile(const Grains<2>& grains, double unit) const {
  BaseProfile profile;
  if (intervals_.empty()) return profile;
  profile.window_start = intervals_.front().start;
  profile.window_end = intervals_.back().end;
  const double scale = 1.0 / ((profile.window_end - profile.window_start) * unit);
  for (const auto k : by_id(grains)) {
    if (!grains.base[k]) continue;
    const auto place = place_of(grains.id[k]);
    Vec<2> impulse;
    for (const auto& interval : intervals_) impulse += interval.impulse[place];
    profile.id.push_back(grains.id[k]);
    profile.x.push_back(grains.line[k].position[0]);
    profile.normal.push_back(-impulse[1] * scale);
    profile.shear.push_back(impulse[0] * scale);
  }
  return profile;
}

double BaseForces::force_on_supports(const Contacts<2>& contacts) const {
  double force = 0.0;
  if (!intervals_.empty()) {
    const double duration = intervals_.back().end - intervals_.front().start;
    for (const auto& interval : intervals_) {
      for (const auto& impulse : interval.impulse) force -= impulse[1] / duration;
    }
  }
  for (const auto& contact : contacts.list) {
    if (contact.second < 0) force += force_of(contact)[1];
  }
  return force;
}

void BaseForces::exchange(Archive& archive) {
  std::vector<double> times;
  std::vector<Vec<2>> impulses;
  for (const auto& interval : intervals_) {
    times.insert(times.end(), {interval.start, interval.end});
    impulses.insert(impulses.end(), interval.impulse.begin(), interval.impulse.end());
  }
  archive.array("run/window_times", times);
  archive.array("run/window_impulses", impulses);
  if (!archive.restoring()) return;
  archive.check("run/window_impulses", 2 * impulses.size() == times.size() * ids_.size());
  intervals_.clear();
  for (std::size_t k = 0; 2 * k + 1 < times.size(); ++k) {
    const auto begin = impulses.begin() + static_cast<std::ptrdiff_t>(k * ids_.size());
    intervals_.push_back({times[2 * k], times[2 * k + 1], {begin, begin + static_cast<std::ptrdiff_t>(ids_.size())}});
  }
}

}  // namespace repose
