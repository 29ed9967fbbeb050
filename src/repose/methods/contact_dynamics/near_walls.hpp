// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/boundaries/walls_near.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace repose::contact_dynamics {

/// The walls that each grain may meet. The list holds as long as the pair list does and no wall has moved by more than
/// half the skin; it is no part of the state, because a longer list gives the same contacts.
template <int D>
class NearWalls {
 public:
  /// Call this when the pair list is built.
  void invalidate() { listed_.clear(); }

  /// Whether the list holds until the end of the step, in which walls keep their speeds.
  bool hold(const std::vector<Wall<D>>& walls, const std::vector<WallState>& states, double dt, double skin) const {
    if (listed_.size() != walls.size()) return false;
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const double so_far = farthest_moved(walls[w], states[w].displacement - listed_[w].displacement);
      const double moved = so_far + dt * farthest_moved(walls[w], states[w].speed);
      if (!(moved <= 0.5 * skin)) return false;
    }
    return true;
  }

  /// Builds the list. Contacts reach up to `cutoff` - 1/2 of a diameter and `reach` [L] from a wall. A grain may have
  /// used up its allowance already, and come back.
  void build(const Grains<D>& grains, const std::vector<Wall<D>>& walls, const std::vector<WallState>& states,
             const std::vector<WallNow<D>>& now, const Box<D>& box, const PairList<D>& pairs, double cutoff,
             double reach) {
    listed_ = states;
    row_start_.assign(1, 0);
    walls_.clear();
    near_.take(walls, now);
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto& grain = grains.line[i];
      const double farthest = near_.reach(cutoff) * grain.radius + reach + 2.0 * pairs.allowance(i);
      const auto add_if_near = [&](std::uint32_t w) {
        const double within = (walls[w].smooth ? 2.0 * cutoff : 2.0 * cutoff - 1.0) * grain.radius;
        const auto place = above(walls[w], now[w], from_wall(walls[w], now[w], grain.position, box));
        if (place.height < within + reach + 2.0 * pairs.allowance(i)) walls_.push_back(w);
      };
      if (!grain.fixed()) near_.each(grain.position, farthest, box, add_if_near);
      row_start_.push_back(static_cast<std::uint32_t>(walls_.size()));
    }
  }

  /// The walls that a grain may meet, ascending.
  std::span<const std::uint32_t> of(std::size_t grain) const {
    return {walls_.data() + row_start_[grain], walls_.data() + row_start_[grain + 1]};
  }

 private:
  std::vector<WallState> listed_;  // the walls when the list was built; empty: it does not hold
  std::vector<std::uint32_t> row_start_;
  std::vector<std::uint32_t> walls_;
  WallsNear<D> near_;
};

}  // namespace repose::contact_dynamics
