// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/boundaries/wall_contacts.hpp"
#include "repose/boundaries/walls_near.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace repose {

/// The twisting displacement of a grain on a wall, in three dimensions.
template <int D>
struct WallTwist {};
template <>
struct WallTwist<3> {
  double twist = 0.0;  ///< [L] zero while apart
};

/// A grain and a wall that may touch before the next build of the list.
template <int D>
struct WallPair : WallTwist<D> {
  std::uint32_t wall = 0;
  std::uint32_t bonded = 0;  ///< 1: bonded to the wall
  Tangent<D> slip{};         ///< [L] slip displacement, zero while apart
  Tangent<D> roll{};         ///< [L] rolling displacement, zero while apart
  Vec<D> force{};            ///< [M L/T^2] force on the grain in the last step
  Vec<D> dissipative{};      ///< [M L/T^2] part of it by dashpot and friction; in a full kernel only
  Vec<D> surface{};          ///< [L/T] velocity of the wall there in the last step, beyond that of its point
  Vec<D> impulse{};          ///< [M L/T] impulse on the grain since it was last collected
};

/// Passes the displacements of contacts whose wall does not act on to the wall that acts for it, where that has none of
/// its own: so slip continues across the seam between two walls. `row` has the pairs of one grain, which `contacts`
/// numbers.
template <int D>
void pass_on_displacements(const WallContacts<D>& contacts, WallPair<D>* row) {
  for (const auto& touch : contacts.all()) {
    auto& from = row[touch.entry];
    auto& to = row[contacts.acting_for(touch).entry];
    if (&from == &to) continue;
    to.bonded |= from.bonded;
    from.bonded = 0;
    bool none = to.slip == Tangent<D>{} && to.roll == Tangent<D>{};
    if constexpr (D == 3) none = none && to.twist == 0.0;
    if (none) {
      to.slip = from.slip;
      to.roll = from.roll;
      if constexpr (D == 3) to.twist = from.twist;
    }
    from.slip = {};
    from.roll = {};
    if constexpr (D == 3) from.twist = 0.0;
  }
}

/// Pairs of grains and walls, for each grain in memory order. The list is built with the pair list and valid as long.
template <int D>
class WallList {
 public:
  std::vector<std::uint32_t> row_start;  ///< (n + 1); empty without walls
  std::vector<WallPair<D>> pairs;
  std::vector<std::vector<std::uint32_t>> of_wall;  ///< for each wall, indices in `pairs`, ascending

  explicit WallList(std::size_t walls) : of_wall(walls) {}

  bool any() const { return !row_start.empty(); }

  /// Builds the list. `order` has the index of each grain at the last build; `cutoff` is the longest reach of a normal
  /// law. A wall may move by half a skin before the next build, as a grain may.
  void build(const Grains<D>& grains, const std::vector<std::uint32_t>& order, const std::vector<Wall<D>>& walls,
             const std::vector<WallNow<D>>& now, const Box<D>& box, const PairList<D>& list, double cutoff,
             double skin) {
    if (walls.empty()) return;
    gather_impulses(walls.size());
    const auto old_start = std::move(row_start);
    const auto old = std::move(pairs);
    row_start.assign(1, 0);
    pairs.clear();
    of_wall.assign(walls.size(), {});
    near_.take(walls, now);
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto& grain = grains.line[i];
      const double farthest = near_.reach(cutoff) * grain.radius + 0.5 * skin + list.allowance(i);
      const auto add_if_near = [&](std::uint32_t w) {
        if (!now[w].present) return;
        const auto& wall = walls[w];
        const Vec<D> from_point = from_wall(wall, now[w], grain.position, box);
        const double within = (wall.smooth ? 2.0 * cutoff : 2.0 * cutoff - 1.0) * grain.radius;
        if (above(wall, now[w], from_point).height >= within + 0.5 * skin + list.allowance(i)) return;
        of_wall[w].push_back(static_cast<std::uint32_t>(pairs.size()));
        pairs.push_back(old_pair(old_start, old, order[i], w));
      };
      if (!grain.fixed()) near_.each(grain.position, farthest, box, add_if_near);
      row_start.push_back(static_cast<std::uint32_t>(pairs.size()));
    }
  }

  /// A copy of the pairs of a grain.
  std::vector<WallPair<D>> row(std::size_t grain) const {
    const auto place = [&](std::size_t k) { return pairs.begin() + static_cast<std::ptrdiff_t>(row_start[k]); };
    return {place(grain), place(grain + 1)};
  }

  void exchange(Archive& archive) {
    archive.array("walls/row_start", row_start);
    archive.array("walls/pairs", pairs);
    archive.array("walls/impulse", impulse_);
    if (!archive.restoring()) return;
    for (auto& list : of_wall) list.clear();
    for (std::uint32_t k = 0; k < pairs.size(); ++k) {
      archive.check("walls/pairs", pairs[k].wall < of_wall.size());
      of_wall[pairs[k].wall].push_back(k);
    }
  }

  /// Impulse of the grains on each wall [M L/T] since the last call.
  std::vector<Vec<D>> take_impulses(std::size_t walls) {
    gather_impulses(walls);
    return std::exchange(impulse_, std::vector<Vec<D>>(walls));
  }

 private:
  static WallPair<D> old_pair(const std::vector<std::uint32_t>& start, const std::vector<WallPair<D>>& old,
                              std::uint32_t row, std::uint32_t wall) {
    WallPair<D> pair;
    pair.wall = wall;
    if (row + 1 >= start.size()) return pair;
    for (auto k = start[row]; k < start[row + 1]; ++k) {
      if (old[k].wall != wall) continue;
      pair.bonded = old[k].bonded;
      pair.slip = old[k].slip;
      pair.roll = old[k].roll;
      if constexpr (D == 3) pair.twist = old[k].twist;
      break;
    }
    return pair;
  }

  void gather_impulses(std::size_t walls) {
    impulse_.resize(walls);
    for (auto& pair : pairs) {
      impulse_[pair.wall] -= pair.impulse;
      pair.impulse = {};
    }
  }

  std::vector<Vec<D>> impulse_;  // [M L/T] impulse of the grains on each wall
  WallsNear<D> near_;
};

}  // namespace repose
