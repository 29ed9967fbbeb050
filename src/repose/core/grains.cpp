// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/grains.hpp"

#include <algorithm>
#include <numeric>

namespace repose {

template <int D>
std::vector<std::uint32_t> by_id(const Grains<D>& grains) {
  std::vector<std::uint32_t> order(grains.size());
  std::iota(order.begin(), order.end(), 0U);
  if (std::is_sorted(grains.id.begin(), grains.id.end())) return order;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return grains.id[a] < grains.id[b]; });
  return order;
}

template <int D>
std::size_t moving_count(const Grains<D>& grains) {
  return static_cast<std::size_t>(
      std::count_if(grains.line.begin(), grains.line.end(), [](const auto& grain) { return !grain.fixed(); }));
}

template <int D>
double kinetic_energy(const Grains<D>& grains) {
  double sum = 0.0;
  for (const auto k : by_id(grains)) {
    if (!grains.line[k].fixed()) sum += kinetic_energy(grains.line[k]);
  }
  return sum;
}

template std::vector<std::uint32_t> by_id(const Grains<2>&);
template std::vector<std::uint32_t> by_id(const Grains<3>&);
template std::size_t moving_count(const Grains<2>&);
template std::size_t moving_count(const Grains<3>&);
template double kinetic_energy(const Grains<2>&);
template double kinetic_energy(const Grains<3>&);

}  // namespace repose
