// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// A wall in reach of a grain.
template <int D>
struct WallTouch {
  std::uint32_t wall = 0;
  std::uint32_t entry = 0;  ///< the caller's number of the pair
  Vec<D> from_point{};      ///< [L] from the wall's point to the centre of the grain
  AboveWall<D> place{};
  std::uint32_t acts = 0;  ///< place in the list of the touch that acts for this one; its own if it acts itself

  Vec<D> nearest() const { return place.normal * -place.height; }  ///< [L] point of the wall, from the centre
  Vec<D> on_wall() const { return from_point + nearest(); }        ///< [L] the same, from the wall's point
};

/// The velocity [L/T] of a wall that turns, where it touches, beyond that of its point; 0 for others.
template <int D>
Vec<D> surface_velocity(const WallNow<D>& now, const WallTouch<D>& touch) {
  return now.turns() ? now.surface_velocity(touch.on_wall(), touch.place.normal) : Vec<D>{};
}

/// The walls in reach of one grain, of which those that meet act as one surface.
///
/// An end of a wall that lies on another wall in reach is no end: only the other wall acts, whose nearest point is
/// nearer. Where the ends of several walls coincide and nothing else is nearer, one of them acts. Of two faces that
/// nearly continue each other at the grain (their normals differ by less than 3 degrees), the nearer one acts. Of equal
/// ones the last acts. Two infinite walls, or a smooth and another wall, are never one surface. Two faces at a larger
/// angle both act: a grain in a corner touches both.
///
/// In three dimensions the other wall need not act itself, and some third wall then acts for both. So of a surface of
/// small triangles those act whose nearest point no other triangle continues nearer to the grain.
/// Validated by tests/unit/wall_contacts_test.cpp, tests/unit/walls_3d_test.cpp, tests/cli/test_walls_that_meet.py.
template <int D>
class WallContacts {
 public:
  void clear() { touches_.clear(); }
  void add(std::uint32_t wall, std::uint32_t entry, const Vec<D>& from_point, const AboveWall<D>& place) {
    touches_.push_back({wall, entry, from_point, place, static_cast<std::uint32_t>(touches_.size())});
  }
  const std::vector<WallTouch<D>>& all() const { return touches_; }
  const WallTouch<D>& acting_for(const WallTouch<D>& touch) const { return touches_[touch.acts]; }
  bool acts(const WallTouch<D>& touch) const { return &acting_for(touch) == &touch; }

  /// Finds which touches act, of walls that stand as `now` says.
  void join(const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now, double radius) {
    if (touches_.size() < 2) return;
    const auto finite = [&](const auto& touch) { return walls[touch.wall].finite(); };
    if (std::none_of(touches_.begin(), touches_.end(), finite)) return;
    order_.clear();
    at_end_.clear();
    for (std::uint32_t k = 0; k < touches_.size(); ++k) {
      order_.push_back(k);
      const auto w = touches_[k].wall;
      at_end_.push_back(beyond_end(walls[w], now[w], touches_[k].from_point) ? 1 : 0);
    }
    // Faces before ends, then the nearest first: whatever acts for another touch comes before it.
    const auto earlier = [&](std::uint32_t a, std::uint32_t b) {
      if (at_end_[a] != at_end_[b]) return at_end_[b] != 0;
      if (touches_[a].place.height != touches_[b].place.height) {
        return touches_[a].place.height < touches_[b].place.height;
      }
      return a > b;
    };
    std::sort(order_.begin(), order_.end(), earlier);
    acting_.clear();
    for (std::size_t done = 0; done < order_.size(); ++done) {
      const auto k = order_[done];
      const auto joins = [&](auto other) { return one_surface(k, other, walls, now, radius); };
      auto found = std::find_if(acting_.begin(), acting_.end(), joins);
      if (D == 3 && found == acting_.end() && at_end_[k] != 0) {
        const auto before = order_.begin() + static_cast<std::ptrdiff_t>(done);
        const auto beside = std::find_if(order_.begin(), before, joins);
        if (beside != before) found = std::find(acting_.begin(), acting_.end(), touches_[*beside].acts);
      }
      if (found == acting_.end()) {
        acting_.push_back(k);
        continue;
      }
      const auto other = *found;
      const double apart = magnitude(touches_[k].nearest() - touches_[other].nearest());
      const bool equal = at_end_[k] == at_end_[other] && apart <= same_point * radius;
      const auto last = equal ? std::max(k, other) : other;
      *found = last;
      for (auto& touch : touches_) {
        if (touch.acts == other) touch.acts = last;
      }
      touches_[k].acts = last;
    }
  }

 private:
  // Fractions of the radius of the grain.
  static constexpr double same_point = 1e-6;
  static constexpr double meeting = 1e-2;         ///< an end this close to a wall lies on it
  static constexpr double same_distance = 1e-9;   ///< rounding
  static constexpr double same_face = 0.06;       ///< nearest points this close, if the normals agree; > tan(3 deg)
  static constexpr double same_normal = 0.99863;  ///< cos(3 deg)

  bool one_surface(std::uint32_t k, std::uint32_t l, const std::vector<Wall<D>>& walls,
                   const std::vector<WallNow<D>>& now, double radius) const {
    const auto& touch = touches_[k];
    const auto& other = touches_[l];
    const auto& wall = walls[touch.wall];
    const auto& other_wall = walls[other.wall];
    if ((!wall.finite() && !other_wall.finite()) || wall.smooth != other_wall.smooth) return false;
    if (at_end_[k] != 0) {
      // The far side of a cylinder does not continue what the near one begins.
      if (D == 3 && dot(touch.place.normal, other.place.normal) < 0.0) return false;
      const double off_wall = above(other_wall, now[other.wall], other.from_point + touch.nearest()).height;
      return other.place.height <= touch.place.height + same_distance * radius &&
             std::fabs(off_wall) <= meeting * radius;
    }
    return at_end_[l] == 0 && dot(touch.place.normal, other.place.normal) > same_normal &&
           magnitude(touch.nearest() - other.nearest()) <= same_face * radius;
  }

  std::vector<WallTouch<D>> touches_;
  std::vector<std::uint8_t> at_end_;  // of each touch: 1 if the nearest point is an end of its wall
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> acting_;
};

}  // namespace repose
