// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/box.hpp"
#include "repose/core/grains.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repose {

/// Drops the grains that have left the box, and with them the entries that a method keeps beside them, one for each
/// grain in memory order. The others keep their order.
template <int D, class T>
void drop_lost(Grains<D>& grains, const Box<D>& box, std::vector<T>& beside) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    if (!grains.line[k].fixed() && box.outside(grains.line[k].position)) continue;
    beside[kept.size()] = beside[k];
    kept.push_back(k);
  }
  beside.resize(kept.size());
  if (kept.size() < grains.size()) grains.reorder(kept);
}

}  // namespace repose
