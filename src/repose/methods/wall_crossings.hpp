// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/boundaries/walls_near.hpp"
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

/// Notices grains that go through finite walls. `check` must be called before any grain can have moved round the end of
/// a wall: the centre has then crossed the wall if the straight line between its places does, in the frame of the wall.
/// Validated by tests/unit/wall_crossings_test.cpp, tests/cli/test_warnings.py.
template <int D>
class WallCrossings {
 public:
  explicit WallCrossings(std::size_t walls) : of_wall_(walls) {}

  void check(const Grains<D>& grains, const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now,
             const Box<D>& box, double time) {
    const auto before = std::move(near_);
    near_.clear();
    near_walls_.take(walls, now);
    constexpr double widest = D == 2 ? 1.5 : 1.0;  // beyond an end, grains are near within a rectangle in 2D
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto& grain = grains.line[i];
      if (grain.fixed()) continue;
      near_walls_.each(grain.position, widest * near * grain.radius, box, [&](std::uint32_t w) {
        if (walls[w].finite() && now[w].present) add_if_near(grain, grains.id[i], w, walls[w], now[w], box);
      });
    }
    const auto order = [](const Near& a, const Near& b) {
      return a.wall != b.wall ? a.wall < b.wall : a.grain < b.grain;
    };
    std::sort(near_.begin(), near_.end(), order);
    for (const auto& place : near_) {
      const auto old = std::lower_bound(before.begin(), before.end(), place, order);
      if (old == before.end() || order(place, *old) || !crosses(*old, place, walls[place.wall])) continue;
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

  /// In radii: farther grains cannot have crossed by the next check, unless they are very fast. Surfaces of thousands
  /// of triangles would make longer lists than is worth while.
  static constexpr double near = D == 2 ? 6.0 : 2.0;

  void add_if_near(const Grain<D>& grain, std::int64_t id, std::uint32_t w, const Wall<D>& wall, const WallNow<D>& now,
                   const Box<D>& box) {
    const Vec<D> from_point = from_wall(wall, now, grain.position, box);
    const double height = dot(from_point, now.normal);
    if constexpr (D == 2) {
      const Vec<2> along = from_point - now.normal * height;
      if (std::fabs(height) > near * grain.radius || magnitude(along) > wall.half_length + near * grain.radius) return;
      const Vec<2> direction{{-now.normal[1], now.normal[0]}};
      const Vec<2> at_start = Vec<2>{{-wall.normal[1], wall.normal[0]}} * dot(along, direction);
      near_.push_back({id, w, height, at_start});
    } else {
      if (std::fabs(above(wall, now, from_point).height) > near * grain.radius) return;
      const Vec<3> across = cross(now.normal, now.side);
      near_.push_back({id, w, height, {{dot(from_point, now.side), dot(from_point, across), height}}});
    }
  }

  static bool crosses(const Near& from, const Near& to, const Wall<D>& wall) {
    if constexpr (D == 3) {
      return passes_through(wall.shape, wall.half_length, from.along, to.along);
    } else {
      if (from.height == 0.0 || (from.height > 0.0) == (to.height > 0.0)) return false;
      const double part = from.height / (from.height - to.height);
      return magnitude(from.along + (to.along - from.along) * part) <= wall.half_length;
    }
  }

  std::vector<Near> near_;  // at the last check, ordered by wall and id
  std::vector<Crossings> of_wall_;
  WallsNear<D> near_walls_;
};

}  // namespace repose
