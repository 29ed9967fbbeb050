// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/discs.hpp"

#include <limits>

namespace repose {

namespace {

template <int D>
Balls<D> balls_of(const OrderedGrains<D>& grains) {
  Balls<D> balls;
  balls.position.reserve(grains.size());
  balls.radius.reserve(grains.size());
  balls.base.reserve(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    balls.add(grains->line[k].position, grains->line[k].radius, grains->base[k] != 0);
  }
  return balls;
}

}  // namespace

Discs discs_of(const OrderedGrains<2>& grains) { return balls_of(grains); }
Spheres spheres_of(const OrderedGrains<3>& grains) { return balls_of(grains); }

template <int D>
std::size_t deposited_count(const Balls<D>& balls) {
  std::size_t count = 0;
  for (const auto is_base : balls.base) count += is_base ? 0 : 1;
  return count;
}

template <int D>
double mean_diameter(const Balls<D>& balls) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (balls.base[k]) continue;
    sum += 2.0 * balls.radius[k];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

template std::size_t deposited_count(const Discs&);
template std::size_t deposited_count(const Spheres&);
template double mean_diameter(const Discs&);
template double mean_diameter(const Spheres&);

}  // namespace repose
