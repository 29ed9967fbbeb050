// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/team.hpp"
#include "repose/methods/soft/pair_force.hpp"
#include "repose/neighbours/pair_list.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace repose::soft {

/// A pair whose second grain is not in reach of its member's ring: it belongs to another member, or lies far away in
/// memory. Its force is computed before the sweep, from the state that every member still has.
struct EdgePair {
  std::uint32_t i;
  std::uint32_t k;  ///< place in the pair list
};

/// Where the force of an edge pair arrives.
struct Arrival {
  std::uint32_t j;
  std::uint32_t member;  ///< whose edge pair
  std::uint32_t edge;    ///< which of them
};

/// A grain in memory on which an outer force acts.
template <int D>
struct LoadedGrain {
  std::uint32_t i;
  std::uint32_t load;  ///< number of the load
  Vec<D> force;        ///< [M L/T^2]
};

/// One member's contiguous range of grains and its workspace.
template <int D, bool Full>
struct Share {
  Range rows;
  std::vector<EdgePair> edges;             ///< ascending by (i, k): the order in which the sweep comes to them
  std::vector<Push<D, Full>> edge_push;    ///< forces of the edges in this step
  std::vector<Arrival> arrivals;           ///< edges that end in this range, ascending by (j, i)
  std::vector<Slot<D, Full>> ring;         ///< size a power of two, more than the bandwidth
  std::vector<std::uint32_t> special;      ///< grains fixed, near a wall or loaded, ascending; then one beyond all
  std::vector<Slot<D, Full>> special_sum;  ///< their pushes by other grains
  std::vector<WallState> walls;            ///< every member moves the walls itself, by the same numbers
  std::vector<WallNow<D>> walls_now;
  double fastest2 = 0.0;  ///< [L^2/T^2] of grains and walls in this step
  bool trouble = false;
};

/// Last partner (exclusive) of row i whose force may go into the ring of the member with these rows.
inline std::uint32_t ring_end(const Range& rows, std::uint32_t i, std::uint32_t far) {
  const auto furthest = static_cast<std::size_t>(i) + far + 1;
  return static_cast<std::uint32_t>(furthest < rows.end ? furthest : rows.end);
}

/// Splits the grains among the members of a team by the work in their rows and finds the edges.
template <int D, bool Full>
std::vector<Share<D, Full>> make_shares(const PairList<D>& pairs, std::size_t grains, int members) {
  std::vector<Share<D, Full>> shares(static_cast<std::size_t>(members));
  const double row_cost = 2.0;  // a row without pairs costs about as much as two pairs
  const double all = static_cast<double>(pairs.pairs()) + row_cost * static_cast<double>(grains);
  std::size_t i = 0;
  for (int m = 0; m < members; ++m) {
    auto& rows = shares[static_cast<std::size_t>(m)].rows;
    rows.begin = i;
    const double until = all * (m + 1) / members;
    while (i < grains && (m + 1 == members || pairs.row_start[i] + row_cost * static_cast<double>(i) < until)) ++i;
    rows.end = i;
  }
  for (std::size_t m = 0; m < shares.size(); ++m) {
    auto& share = shares[m];
    for (auto row = static_cast<std::uint32_t>(share.rows.begin); row < share.rows.end; ++row) {
      const auto end = ring_end(share.rows, row, PairList<D>::far);
      for (auto k = pairs.row_start[row]; k < pairs.row_start[row + 1]; ++k) {
        if (pairs.partner[k] >= end) share.edges.push_back({row, k});
      }
    }
    share.edge_push.resize(share.edges.size());
    share.ring.assign(std::bit_ceil(static_cast<std::size_t>(pairs.bandwidth) + 1), {});
    for (std::size_t e = 0; e < share.edges.size(); ++e) {
      const auto j = pairs.partner[share.edges[e].k];
      std::size_t home = m;
      while (j >= shares[home].rows.end) ++home;
      shares[home].arrivals.push_back({j, static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(e)});
    }
  }
  // Members and their edges were gone through by ascending i, so a stable sort by j leaves i ascending for each j.
  for (auto& share : shares) {
    std::stable_sort(share.arrivals.begin(), share.arrivals.end(),
                     [](const Arrival& a, const Arrival& b) { return a.j < b.j; });
  }
  return shares;
}

}  // namespace repose::soft
