// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_graph.hpp"

#include "repose/analysis/near_spheres.hpp"
#include "repose/core/errors.hpp"
#include "repose/neighbours/near_pairs.hpp"

#include <algorithm>

namespace repose {

template <int D>
ContactGraph contact_graph(const Balls<D>& balls, const Box<D>& box, double gap) {
  ContactGraph graph;
  auto& start = graph.start;
  start.assign(balls.size() + 1, 0);
  if (balls.size() == 0) return graph;
  const double largest = *std::max_element(balls.radius.begin(), balls.radius.end());
  // Contacts are found twice, first to count them: a list of them would need more memory than the graph.
  const auto for_contacts = [&](const auto& use) {
    for_near_pairs(balls.position, box, 2.0 * largest * (1.0 + gap), [&](std::uint32_t i, std::uint32_t j) {
      if (touch(balls, box, gap, i, j)) use(i, j);
    });
  };
  for_contacts([&](std::uint32_t i, std::uint32_t j) {
    ++start[i];
    ++start[j];
  });
  // Each start is the end of its grain until the neighbours are filled in from there downward.
  for (std::size_t k = 0; k < balls.size(); ++k) start[k + 1] += start[k];
  graph.neighbour.resize(start.back());
  for_contacts([&](std::uint32_t i, std::uint32_t j) {
    graph.neighbour[--start[i]] = j;
    graph.neighbour[--start[j]] = i;
  });
  for (std::size_t k = 0; k < balls.size(); ++k) {
    std::sort(graph.neighbour.begin() + start[k], graph.neighbour.begin() + start[k + 1]);
  }
  return graph;
}

template <int D>
std::vector<std::uint8_t> wall_contacts(const Balls<D>& balls, const PackingWalls& walls, double gap) {
  std::vector<std::uint8_t> count(balls.size(), 0);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const double reach = balls.radius[k] * (1.0 + 2.0 * gap);
    const auto& centre = balls.position[k];
    if (walls.floor && centre[up<D>] - *walls.floor < reach) ++count[k];
    if (walls.left && centre[0] - *walls.left < reach) ++count[k];
    if (walls.right && *walls.right - centre[0] < reach) ++count[k];
    if constexpr (D == 3) {
      if (walls.front && centre[1] - *walls.front < reach) ++count[k];
      if (walls.back && *walls.back - centre[1] < reach) ++count[k];
    }
  }
  return count;
}

template <int D>
std::vector<std::uint8_t> rattlers(const Balls<D>& balls, const ContactGraph& graph,
                                   const std::vector<std::uint8_t>& on_walls, std::size_t least) {
  REPOSE_ASSERT(on_walls.size() == balls.size());
  std::vector<std::uint8_t> gone(balls.size(), 0);
  std::vector<std::uint32_t> left(balls.size());
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t k = 0; k < balls.size(); ++k) {
    left[k] = static_cast<std::uint32_t>(graph.degree(k)) + on_walls[k];
    if (balls.base[k] || left[k] >= least) continue;
    gone[k] = 1;
    waiting.push_back(k);
  }
  while (!waiting.empty()) {
    const auto ball = waiting.back();
    waiting.pop_back();
    for (const auto other : graph.of(ball)) {
      --left[other];
      if (gone[other] || balls.base[other] || left[other] >= least) continue;
      gone[other] = 1;
      waiting.push_back(other);
    }
  }
  return gone;
}

template ContactGraph contact_graph(const Discs&, const Box<2>&, double);
template ContactGraph contact_graph(const Spheres&, const Box<3>&, double);
template std::vector<std::uint8_t> wall_contacts(const Discs&, const PackingWalls&, double);
template std::vector<std::uint8_t> wall_contacts(const Spheres&, const PackingWalls&, double);
template std::vector<std::uint8_t> rattlers(const Discs&, const ContactGraph&, const std::vector<std::uint8_t>&,
                                            std::size_t);
template std::vector<std::uint8_t> rattlers(const Spheres&, const ContactGraph&, const std::vector<std::uint8_t>&,
                                            std::size_t);

}  // namespace repose
