// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/base_forces.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace repose {

template <int D>
BaseProfile floor_profile(const Grains<D>& grains, const Contacts<D>& contacts, std::int64_t wall, double time,
                          double unit) {
  std::unordered_map<std::int64_t, Vec<D>> place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], grains.line[k].position);
  struct Carried {
    Vec<D> place;
    std::int64_t id;
    Vec<D> force;  // of the wall
    bool operator<(const Carried& other) const { return std::pair(place[0], id) < std::pair(other.place[0], other.id); }
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
    profile.x.push_back(one.place[0]);
    profile.normal.push_back(one.force[up<D>] / unit);
    profile.shear.push_back(-one.force[0] / unit);
    if constexpr (D == 3) {
      profile.y.push_back(one.place[1]);
      profile.shear_y.push_back(-one.force[1] / unit);
    }
  }
  return profile;
}

template <int D>
BaseForces<D>::BaseForces(const Grains<D>& grains, double window, double tolerance)
    : window_(window), tolerance_(tolerance) {
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (grains.line[k].fixed()) ids_.push_back(grains.id[k]);
  }
}

template <int D>
std::size_t BaseForces<D>::place_of(std::int64_t id) const {
  return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

template <int D>
void BaseForces<D>::record(Grains<D>& grains, double time) {
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

template <int D>
BaseProfile BaseForces<D>::profile(const Grains<D>& grains, double unit) const {
  BaseProfile profile;
  if (intervals_.empty()) return profile;
  profile.window_start = intervals_.front().start;
  profile.window_end = intervals_.back().end;
  const double scale = 1.0 / ((profile.window_end - profile.window_start) * unit);
  for (const auto k : by_id(grains)) {
    if (!grains.base[k]) continue;
    const auto place = place_of(grains.id[k]);
    Vec<D> impulse;
    for (const auto& interval : intervals_) impulse += interval.impulse[place];
    profile.id.push_back(grains.id[k]);
    profile.x.push_back(grains.line[k].position[0]);
    profile.normal.push_back(-impulse[up<D>] * scale);
    profile.shear.push_back(impulse[0] * scale);
    if constexpr (D == 3) {
      profile.y.push_back(grains.line[k].position[1]);
      profile.shear_y.push_back(impulse[1] * scale);
    }
  }
  return profile;
}

template <int D>
double BaseForces<D>::force_on_supports(const Contacts<D>& contacts) const {
  double force = 0.0;
  if (!intervals_.empty()) {
    const double duration = intervals_.back().end - intervals_.front().start;
    for (const auto& interval : intervals_) {
      for (const auto& impulse : interval.impulse) force -= impulse[up<D>] / duration;
    }
  }
  for (const auto& contact : contacts.list) {
    if (contact.second < 0) force += force_of(contact)[up<D>];
  }
  return force;
}

template <int D>
void BaseForces<D>::exchange(Archive& archive) {
  std::vector<double> times;
  std::vector<Vec<D>> impulses;
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

template BaseProfile floor_profile(const Grains<2>&, const Contacts<2>&, std::int64_t, double, double);
template BaseProfile floor_profile(const Grains<3>&, const Contacts<3>&, std::int64_t, double, double);
template class BaseForces<2>;
template class BaseForces<3>;

}  // namespace repose
