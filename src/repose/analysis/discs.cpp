// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/discs.hpp"

#include <limits>

namespace repose {

Discs discs_of(const OrderedGrains<2>& grains) {
  Discs discs;
  discs.position.reserve(grains.size());
  discs.radius.reserve(grains.size());
  discs.base.reserve(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    discs.add(grains->line[k].position, grains->line[k].radius, grains->base[k] != 0);
  }
  return discs;
}

std::size_t deposited_count(const Discs& discs) {
  std::size_t count = 0;
  for (const auto is_base : discs.base) count += is_base ? 0 : 1;
  return count;
}

double mean_diameter(const Discs& discs) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    if (discs.base[k]) continue;
    sum += 2.0 * discs.radius[k];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace repose
