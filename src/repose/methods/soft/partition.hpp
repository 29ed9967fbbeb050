// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall_contacts.hpp"
#include "repose/core/inline.hpp"
#include "repose/core/team.hpp"
#include "repose/core/vec.hpp"
#include "repose/methods/method.hpp"
#include "repose/methods/wall_list.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace repose::soft {

/// A pair whose second grain is out of reach of the member's ring: it belongs to another member, or lies far away in
/// memory. Its force is computed before the sweep, while no grain has moved.
struct EdgePair {
  std::uint32_t i;  ///< index of the first grain
  std::uint32_t k;  ///< index in the pair list
};

/// The force of an edge pair on its second grain.
struct Arrival {
  std::uint32_t j;       ///< index of the second grain
  std::uint32_t member;  ///< member that computes the edge pair
  std::uint32_t edge;    ///< index among the edge pairs of that member
};

/// A grain on which an external force acts.
template <int D>
struct LoadedGrain {
  std::uint32_t i;     ///< index of the grain
  std::uint32_t load;  ///< number of the load
  Vec<D> force;        ///< [M L/T^2]
};

/// The grains on which loads act, ascending by their index.
template <int D>
std::vector<LoadedGrain<D>> find_loaded(const Grains<D>& grains, const std::vector<Load<D>>& loads) {
  std::vector<LoadedGrain<D>> loaded;
  if (loads.empty()) return loaded;
  std::unordered_multimap<std::int64_t, std::uint32_t> load_of;
  for (std::uint32_t load = 0; load < loads.size(); ++load) load_of.emplace(loads[load].grain, load);
  for (std::uint32_t i = 0; i < grains.size(); ++i) {
    const auto [first, last] = load_of.equal_range(grains.id[i]);
    for (auto found = first; found != last; ++found) loaded.push_back({i, found->second, loads[found->second].force});
  }
  std::sort(loaded.begin(), loaded.end(),
            [](const auto& a, const auto& b) { return a.i != b.i ? a.i < b.i : a.load < b.load; });
  return loaded;
}

/// The contiguous range of grains of one member of the team, and what it knows of its step.
template <int D>
struct alignas(64) Part {
  Range rows;
  std::vector<EdgePair> edges;         ///< ascending by (i, k), the order of the sweep
  std::vector<Arrival> arrivals;       ///< edge pairs whose second grain is in this range, ascending by (j, i)
  std::vector<std::uint32_t> special;  ///< fixed, near a wall or loaded grains, ascending; the last is a sentinel
  std::vector<WallState> walls;        ///< every member moves the walls itself, from the same numbers
  std::vector<WallNow<D>> walls_now;
  WallContacts<D> at_walls;  ///< of the grain at hand
  Vec<D> fastest{};          ///< [L/T] largest magnitude of each component of a grain's velocity in this step
  bool trouble = false;
};

/// Finds the grains of a part that are fixed, near a wall or loaded, so that the sweep must do more than move them.
template <int D>
void find_special(const Grains<D>& grains, const std::vector<LoadedGrain<D>>& all_loaded, const WallList<D>& walls,
                  Part<D>& part) {
  auto loaded = std::lower_bound(all_loaded.begin(), all_loaded.end(), part.rows.begin,
                                 [](const auto& grain, std::size_t row) { return grain.i < row; });
  for (auto i = static_cast<std::uint32_t>(part.rows.begin); i < part.rows.end; ++i) {
    const bool near_wall = walls.any() && walls.row_start[i] != walls.row_start[i + 1];
    const bool is_loaded = loaded != all_loaded.end() && loaded->i == i;
    if (near_wall || is_loaded || grains.line[i].fixed()) part.special.push_back(i);
    while (loaded != all_loaded.end() && loaded->i == i) ++loaded;
  }
  part.special.push_back(std::numeric_limits<std::uint32_t>::max());
}

/// Takes note of the speed of a grain that has moved. A component above the limit [L/T] is too fast to follow.
template <int D>
REPOSE_FN void watch(const Vec<D>& velocity, double limit, Part<D>& part) {
  for (int k = 0; k < D; ++k) {
    const double speed = std::fabs(velocity[k]);
    part.trouble |= !(speed < limit);  // also true for NaN
    if (speed > part.fastest[k]) part.fastest[k] = speed;
  }
}

/// The end (exclusive) of the partners of row i whose forces go into the ring of the member with these rows.
inline std::uint32_t ring_end(const Range& rows, std::uint32_t i, std::uint32_t far) {
  const auto furthest = static_cast<std::size_t>(i) + far + 1;
  return static_cast<std::uint32_t>(furthest < rows.end ? furthest : rows.end);
}

/// Divides the grains among the members of a team by the work in their rows, and finds the edge pairs. `Space` is a
/// Part with the working memory of a kernel.
template <class Space, int D>
std::vector<Space> make_parts(const PairList<D>& pairs, std::size_t grains, int members) {
  std::vector<Space> parts(static_cast<std::size_t>(members));
  const double row_cost = 2.0;  // a row without pairs costs about as much as two pairs
  const double all = static_cast<double>(pairs.pairs()) + row_cost * static_cast<double>(grains);
  std::size_t i = 0;
  for (int m = 0; m < members; ++m) {
    auto& rows = parts[static_cast<std::size_t>(m)].rows;
    rows.begin = i;
    const double until = all * (m + 1) / members;
    if (m + 1 == members) i = grains;
    while (i < grains && pairs.row_start[i] + row_cost * static_cast<double>(i) < until) ++i;
    rows.end = i;
  }
  for (std::size_t m = 0; m < parts.size(); ++m) {
    auto& part = parts[m];
    if (members == 1 && !pairs.any_far) break;
    for (auto row = static_cast<std::uint32_t>(part.rows.begin); row < part.rows.end; ++row) {
      const auto end = ring_end(part.rows, row, PairList<D>::far);
      for (auto k = pairs.row_start[row]; k < pairs.row_start[row + 1]; ++k) {
        if (pairs.partner[k] >= end) part.edges.push_back({row, k});
      }
    }
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
      const auto j = pairs.partner[part.edges[e].k];
      std::size_t home = m;
      while (j >= parts[home].rows.end) ++home;
      parts[home].arrivals.push_back({j, static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(e)});
    }
  }
  // Arrivals were added by ascending i, so a stable sort by j leaves i ascending for each j.
  for (auto& part : parts) {
    std::stable_sort(part.arrivals.begin(), part.arrivals.end(),
                     [](const Arrival& a, const Arrival& b) { return a.j < b.j; });
  }
  return parts;
}

}  // namespace repose::soft
