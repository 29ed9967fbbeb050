// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/coordination.hpp"

#include "repose/core/errors.hpp"

#include <algorithm>

namespace repose {

namespace {

// The sums of each block; the numbers of discs with 0 to 6 contacts come last.
enum Sum : std::size_t { all, ends, kept, kept_ends, with_0 };
constexpr std::size_t sums_count = with_0 + 7;

}  // namespace

Coordination measure_coordination(const Discs& discs, const ContactGraph& graph,
                                  const std::vector<std::uint8_t>& on_walls, const std::vector<std::uint8_t>& rattler,
                                  const Slab& slab, std::size_t blocks) {
  REPOSE_ASSERT(on_walls.size() == discs.size() && rattler.size() == discs.size());
  std::vector<std::array<double, sums_count>> sums(blocks);
  Coordination result;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    if (discs.base[k] || !slab.holds(discs.position[k])) continue;
    ++result.discs;
    auto& sum = sums[block_of(slab, discs.position[k][0], blocks)];
    const std::size_t contacts = graph.degree(k) + on_walls[k];
    sum[all] += 1.0;
    sum[ends] += static_cast<double>(contacts);
    sum[with_0 + std::min<std::size_t>(contacts, 6)] += 1.0;
    if (rattler[k]) continue;
    sum[kept] += 1.0;
    sum[kept_ends] += on_walls[k];
    for (const auto other : graph.of(k)) sum[kept_ends] += rattler[other] ? 0.0 : 1.0;
  }
  result.mean = over_blocks(sums, [](const auto& sum) { return sum[ends] / sum[all]; });
  result.without_rattlers = over_blocks(sums, [](const auto& sum) { return sum[kept_ends] / sum[kept]; });
  result.rattlers = over_blocks(sums, [](const auto& sum) { return 1.0 - sum[kept] / sum[all]; }).mean;
  for (std::size_t q = 0; q < 7; ++q) {
    const auto fraction = over_blocks(sums, [q](const auto& sum) { return sum[with_0 + q] / sum[all]; });
    result.connectivity[q] = fraction.mean;
    result.connectivity_error[q] = fraction.error;
  }
  return result;
}

}  // namespace repose
