// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_graph.hpp"

#include "repose/core/errors.hpp"
#include "repose/neighbours/near_pairs.hpp"

#include <algorithm>

namespace repose {

ContactGraph contact_graph(const Discs& discs, const Box<2>& box, double gap) {
  ContactGraph graph;
  auto& start = graph.start;
  start.assign(discs.size() + 1, 0);
  if (discs.size() == 0) return graph;
  const double largest = *std::max_element(discs.radius.begin(), discs.radius.end());
  // Contacts are found twice, first to count them: a list of them would need more memory than the graph.
  const auto for_contacts = [&](const auto& use) {
    for_near_pairs(discs.position, box, 2.0 * largest * (1.0 + gap), [&](std::uint32_t i, std::uint32_t j) {
      if (touch(discs, box, gap, i, j)) use(i, j);
    });
  };
  for_contacts([&](std::uint32_t i, std::uint32_t j) {
    ++start[i];
    ++start[j];
  });
  // Each start is the end of its disc until the neighbours are filled in from there downward.
  for (std::size_t k = 0; k < discs.size(); ++k) start[k + 1] += start[k];
  graph.neighbour.resize(start.back());
  for_contacts([&](std::uint32_t i, std::uint32_t j) {
    graph.neighbour[--start[i]] = j;
    graph.neighbour[--start[j]] = i;
  });
  for (std::size_t k = 0; k < discs.size(); ++k) {
    std::sort(graph.neighbour.begin() + start[k], graph.neighbour.begin() + start[k + 1]);
  }
  return graph;
}

std::vector<std::uint8_t> wall_contacts(const Discs& discs, const PackingWalls& walls, double gap) {
  std::vector<std::uint8_t> count(discs.size(), 0);
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const double reach = discs.radius[k] * (1.0 + 2.0 * gap);
    const auto& centre = discs.position[k];
    if (walls.floor && centre[1] - *walls.floor < reach) ++count[k];
    if (walls.left && centre[0] - *walls.left < reach) ++count[k];
    if (walls.right && *walls.right - centre[0] < reach) ++count[k];
  }
  return count;
}

std::vector<std::uint8_t> rattlers(const Discs& discs, const ContactGraph& graph,
                                   const std::vector<std::uint8_t>& on_walls, std::size_t least) {
  REPOSE_ASSERT(on_walls.size() == discs.size());
  std::vector<std::uint8_t> gone(discs.size(), 0);
  std::vector<std::uint32_t> left(discs.size());
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t k = 0; k < discs.size(); ++k) {
    left[k] = static_cast<std::uint32_t>(graph.degree(k)) + on_walls[k];
    if (discs.base[k] || left[k] >= least) continue;
    gone[k] = 1;
    waiting.push_back(k);
  }
  while (!waiting.empty()) {
    const auto disc = waiting.back();
    waiting.pop_back();
    for (const auto other : graph.of(disc)) {
      --left[other];
      if (gone[other] || discs.base[other] || left[other] >= least) continue;
      gone[other] = 1;
      waiting.push_back(other);
    }
  }
  return gone;
}

}  // namespace repose
