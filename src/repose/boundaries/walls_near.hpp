// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// Half the extent [L] of a finite wall along each axis of space, about its point.
template <int D>
Vec<D> half_extent(const Wall<D>& wall, const WallNow<D>& now) {
  if constexpr (D == 3) {
    return half_extent(wall.shape, wall.half_length, now.normal, now.side);
  } else {
    return {{wall.half_length * std::fabs(now.normal[1]), wall.half_length * std::fabs(now.normal[0])}};
  }
}

/// Finds the walls near a place. Among few walls it visits all; above that a tree of boxes leaves out finite walls that
/// are too far away, so that a surface of thousands of triangles costs a grain little.
/// Validated by tests/unit/walls_near_test.cpp.
template <int D>
class WallsNear {
 public:
  /// Takes walls as they stand now. The tree of the last call is used again where they stand as they did.
  void take(const std::vector<Wall<D>>& walls, const std::vector<WallNow<D>>& now) {
    std::vector<Bounds> bounds;
    everywhere_.clear();
    any_smooth_ = std::any_of(walls.begin(), walls.end(), [](const auto& wall) { return wall.smooth; });
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      if (walls.size() <= few || !walls[w].finite()) {
        everywhere_.push_back(w);
      } else {
        bounds.push_back(bounds_of(walls[w], now[w], w));
      }
    }
    if (bounds == bounds_) return;
    bounds_ = std::move(bounds);
    nodes_.clear();
    sorted_ = bounds_;
    if (!sorted_.empty()) add_node(0, sorted_.size());
  }

  /// How far [radii] a wall reaches that acts on grains whose centres are closer than `cutoff` diameters to each other:
  /// the farthest of all.
  double reach(double cutoff) const { return any_smooth_ ? 2.0 * cutoff : 2.0 * cutoff - 1.0; }

  /// Calls use(w), w ascending, for every wall that is closer than `reach` [L] to a place by the nearest image of its
  /// point, and for some that are not.
  template <class Use>
  void each(const Vec<D>& place, double reach, const Box<D>& box, const Use& use) {
    if (nodes_.empty()) {
      for (const auto w : everywhere_) use(w);
      return;
    }
    found_ = everywhere_;
    const bool periodic_y = D == 3 && box.periodic_y;
    for (int x = box.periodic ? -1 : 0; x <= (box.periodic ? 1 : 0); ++x) {
      for (int y = periodic_y ? -1 : 0; y <= (periodic_y ? 1 : 0); ++y) {
        Vec<D> image = place;
        if (x != 0) image[0] += x * box.width();
        if (y != 0) image[1] += y * box.depth();
        find(image, reach);
      }
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    for (const auto w : found_) use(w);
  }

 private:
  static constexpr std::size_t few = 24;
  static constexpr std::size_t leaf = 4;  ///< walls of the smallest boxes

  struct Bounds {
    Vec<D> low{};
    Vec<D> high{};
    std::uint32_t wall = 0;
    friend bool operator==(const Bounds&, const Bounds&) = default;
  };
  /// A box over some walls: those of a leaf, or those of its two halves, the first of which follows it.
  struct Node {
    Vec<D> low{};
    Vec<D> high{};
    std::uint32_t begin = 0;
    std::uint32_t end = 0;     // in `sorted_`; 0: no leaf
    std::uint32_t second = 0;  // the other half
  };

  static Bounds bounds_of(const Wall<D>& wall, const WallNow<D>& now, std::uint32_t number) {
    Bounds bounds{now.point, now.point, number};
    const Vec<D> half = half_extent(wall, now);
    for (int k = 0; k < D; ++k) {
      const double extent = half[k] + 1e-9 * wall.half_length + 1e-12 * std::fabs(now.point[k]);  // rounding
      bounds.low[k] -= extent;
      bounds.high[k] += extent;
    }
    return bounds;
  }

  void add_node(std::size_t begin, std::size_t end) {
    const auto number = nodes_.size();
    Node node{sorted_[begin].low, sorted_[begin].high};
    for (std::size_t k = begin + 1; k < end; ++k) {
      for (int axis = 0; axis < D; ++axis) {
        node.low[axis] = std::min<double>(node.low[axis], sorted_[k].low[axis]);
        node.high[axis] = std::max<double>(node.high[axis], sorted_[k].high[axis]);
      }
    }
    if (end - begin <= leaf) {
      node.begin = static_cast<std::uint32_t>(begin);
      node.end = static_cast<std::uint32_t>(end);
      nodes_.push_back(node);
      return;
    }
    nodes_.push_back(node);
    int longest = 0;
    for (int axis = 1; axis < D; ++axis) {
      if (node.high[axis] - node.low[axis] > node.high[longest] - node.low[longest]) longest = axis;
    }
    const auto at = [&](std::size_t k) { return sorted_.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](const Bounds& a, const Bounds& b) {
      const double twice_a = a.low[longest] + a.high[longest];
      const double twice_b = b.low[longest] + b.high[longest];
      return twice_a != twice_b ? twice_a < twice_b : a.wall < b.wall;
    });
    add_node(begin, middle);
    nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
    add_node(middle, end);
  }

  template <class Bounded>
  static bool within(const Bounded& bounds, const Vec<D>& place, double reach) {
    double distance2 = 0.0;
    for (int k = 0; k < D; ++k) {
      const double beside = std::max(bounds.low[k] - place[k], place[k] - bounds.high[k]);
      if (beside > 0.0) distance2 += beside * beside;
    }
    return distance2 <= reach * reach;
  }

  void find(const Vec<D>& place, double reach) {
    pending_.assign(1, 0);
    while (!pending_.empty()) {
      const auto number = pending_.back();
      pending_.pop_back();
      const auto& node = nodes_[number];
      if (!within(node, place, reach)) continue;
      for (auto k = node.begin; k < node.end; ++k) {
        if (within(sorted_[k], place, reach)) found_.push_back(sorted_[k].wall);
      }
      if (node.end != 0) continue;
      pending_.push_back(node.second);
      pending_.push_back(number + 1);
    }
  }

  bool any_smooth_ = false;
  std::vector<std::uint32_t> everywhere_;  // infinite walls; all where there are few
  std::vector<Bounds> bounds_;             // finite walls, ascending
  std::vector<Bounds> sorted_;
  std::vector<Node> nodes_;
  // Working memory.
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> pending_;
};

}  // namespace repose
