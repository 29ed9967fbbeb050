// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/bases/bed.hpp"

#include "repose/core/random.hpp"
#include "repose/simulation/sources/initial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace repose {

/// Rows along x, every other one shifted by half a spacing, as far as the round base reaches.
void BedBase::add_grains(const Scene& scene, Grains<3>& grains, std::int64_t& id) const {
  const auto seed = static_cast<std::uint64_t>(scene.seed);
  const double row_distance = 0.5 * std::sqrt(3.0) * spacing;
  const long rows = static_cast<long>(std::floor(radius / row_distance + 1e-9));
  std::vector<Vec<3>> places;
  for (long row = -rows; row <= rows; ++row) {
    const double y = static_cast<double>(row) * row_distance;
    const double shift = row % 2 == 0 ? 0.0 : 0.5 * spacing;
    const long side = static_cast<long>(std::ceil(radius / spacing)) + 1;
    for (long k = -side; k <= side; ++k) {
      const double x = static_cast<double>(k) * spacing + shift;
      if (x * x + y * y <= radius * radius * (1.0 + 1e-9)) places.push_back({{x, y, 0.0}});
    }
  }
  std::uint64_t index = 0;
  for (auto& place : places) {
    const auto random = [&](std::uint32_t draw) { return uniform(seed, Purpose::base_height, index, draw); };
    place[0] += disorder * (2.0 * random(1) - 1.0);
    place[1] += disorder * (2.0 * random(2) - 1.0);
    place[2] -= roughness * random(0);
    ++index;
  }
  std::sort(places.begin(), places.end(),
            [](const auto& a, const auto& b) { return std::tie(a[0], a[1]) < std::tie(b[0], b[1]); });
  auto grain = make_grain<3>(scene, scene.grains.diameter, material);
  grain.inverse_mass = 0.0;
  const auto number = scene.material_number(material);
  for (const auto& place : places) {
    grain.position = place;
    grains.add(grain, id++, true, number);
  }
}

}  // namespace repose
