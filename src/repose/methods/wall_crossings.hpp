// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// The grains whose centres went through a wall.
struct Crossings {
  std::int64_t count = 0;
  std::int64_t first = -1;  ///< id of the first grain
  double time = 0.0;        ///< [T] by which that was noticed
};

/// Notices grains that go through walls of finite length. `check` must be called before any grain can have moved round
/// the end of a wall: the centre has then crossed the wall if the straight line between its places does, in the frame
/// of the wall. Validated by tests/unit/wall_crossings_test.cpp, tests/cli/test_warnings.py.
template <int D>
class WallCrossings {
 public:
  explicit WallCrossings(std::size_t walls) : of_wall_(walls) {}

  void check(const Grains<D>& grains, const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now,
             const Box<D>& box, double time) {
    const auto before = std::move(near_);
    near_.clear();
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      if (walls[w].finite() && now[w].present) add_near(grains, w, walls[w], now[w], box);
    }
    const auto order = [](const Near& a, const Near& b) {
      return a.wall != b.wall ? a.wall < b.wall : a.grain < b.grain;
    };
    std::sort(near_.begin(), near_.end(), order);
    for (const auto& place : near_) {
      const auto old = std::lower_bound(before.begin(), before.end(), place, order);
      if (old == before.end() || order(place, *old) || !crosses(*old, place, walls[place.wall].half_length)) continue;
      auto& crossed = of_wall_[place.wall];
      if (crossed.count++ == 0) crossed = {1, place.grain, time};
    }
  }

  /// The crossings up to the present state.
  std::vector<Crossings> until(const Grains<D>& grains, const std::vector<Wall<D>>& walls,
                               const std::vector<WallNow<D>>& now, const Box<D>& box, double time) const {
    auto present = *this;
    present.check(grains, walls, now, box, time);
    return present.of_wall_;
  }

  void exchange(Archive& archive) {
    const auto walls = of_wall_.size();
    archive.array("walls/near", near_);
    archive.array("walls/crossings", of_wall_);
    archive.check("walls/crossings", of_wall_.size() == walls);
  }

 private:
  /// A grain near a wall, in the frame of the wall.
  struct Near {
    std::int64_t grain = 0;  // id
    std::uint64_t wall = 0;
    double height = 0.0;  // [L] along the normal
    Vec<D> along{};       // [L] from the wall's point, in directions that turn with the wall
  };

  static constexpr double near = 6.0;  ///< radii: farther grains cannot have crossed by the next check

  void add_near(const Grains<D>& grains, std::uint32_t w, const Wall<D>& wall, const WallNow<D>& now,
                const Box<D>& box) {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto& grain = grains.line[i];
      if (grain.fixed()) continue;
      const Vec<D> from_point = from_wall(wall, now, grain.position, box);
      const double height = dot(from_point, now.normal);
      const Vec<D> along = from_point - now.normal * height;
      if (std::fabs(height) > near * grain.radius || magnitude(along) > wall.half_length + near * grain.radius)
        continue;
      near_.push_back({grains.id[i], w, height, in_frame(along, now.normal, wall.normal)});
    }
  }

  /// A vector along the wall, turned back by as much as the wall has turned.
  static Vec<D> in_frame(const Vec<D>& along, const Vec<D>& normal, const Vec<D>& normal_at_start) {
    if constexpr (D == 2) {
      const Vec<2> direction{{-normal[1], normal[0]}};
      return Vec<2>{{-normal_at_start[1], normal_at_start[0]}} * dot(along, direction);
    } else {
      return along;  // walls that turn have no rim yet whose pieces differ
    }
  }

  static bool crosses(const Near& from, const Near& to, double half_length) {
    if (from.height == 0.0 || (from.height > 0.0) == (to.height > 0.0)) return false;
    const double part = from.height / (from.height - to.height);
    return magnitude(from.along + (to.along - from.along) * part) <= half_length;
  }

  std::vector<Near> near_;  // at the last check, ordered by wall and id
  std::vector<Crossings> of_wall_;
};

}  // namespace repose
