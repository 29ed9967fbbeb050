// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/sphere_packing.hpp"

#include "repose/analysis/sphere_columns.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

// The sums of each block; the numbers of spheres with 0, 1, ... contacts come last.
enum Sum : std::size_t { all, ends, kept, kept_ends, solid, space, with_0 };
constexpr std::size_t sums_count = with_0 + most_contacts<3> + 1;
using Sums = std::array<double, sums_count>;

constexpr double low_edge = 0.4;  // [mean heights]
constexpr double high_edge = 1.4;

/// A statistic of the sums, and its error by the jackknife over blocks.
template <class Statistic>
Estimate of_sums(const std::vector<Sums>& blocks, const Statistic& statistic) {
  return jackknife(blocks.size(), [&](std::size_t without) {
    Sums sums{};
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (b == without) continue;
      for (std::size_t k = 0; k < sums_count; ++k) sums[k] += blocks[b][k];
    }
    return static_cast<double>(statistic(sums));
  });
}

std::size_t sector_of(const Vec<3>& point, const Vec<2>& axis, std::size_t count) {
  double turn = std::atan2(point[1] - axis[1], point[0] - axis[0]) / (2.0 * std::numbers::pi);
  if (turn < 0.0) turn += 1.0;
  return std::min(count - 1, static_cast<std::size_t>(turn * static_cast<double>(count)));
}

}  // namespace

PackingCore usual_core(const Spheres& spheres, double base_height) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres.base[k]) continue;
    sum += spheres.position[k][2] - base_height;
    count += 1.0;
  }
  const double mean = count > 0.0 ? sum / count : no_number;
  return {.low = base_height + low_edge * mean, .high = base_height + high_edge * mean};
}

SpherePacking measure_sphere_packing(const Spheres& spheres, const std::vector<SphereCell>& cells,
                                     const ContactGraph& graph, const std::vector<std::uint8_t>& on_walls,
                                     const std::vector<std::uint8_t>& rattler, const PackingCore& core,
                                     std::size_t blocks) {
  REPOSE_ASSERT(on_walls.size() == spheres.size() && rattler.size() == spheres.size());
  SpherePacking packing;
  std::vector<Sums> sums(blocks);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres.base[k] || !core.holds(spheres.position[k])) continue;
    ++packing.spheres;
    auto& sum = sums[sector_of(spheres.position[k], core.axis, blocks)];
    const std::size_t contacts = graph.degree(k) + on_walls[k];
    sum[all] += 1.0;
    sum[ends] += static_cast<double>(contacts);
    sum[with_0 + std::min(contacts, most_contacts<3>)] += 1.0;
    if (rattler[k]) continue;
    sum[kept] += 1.0;
    sum[kept_ends] += on_walls[k];
    for (const auto other : graph.of(k)) sum[kept_ends] += rattler[other] ? 0.0 : 1.0;
  }
  for (const auto& cell : cells) {
    const auto k = cell.place;
    if (!cell.closed || !(cell.volume > 0.0)) continue;
    if (spheres.base[k] || !core.holds(spheres.position[k])) continue;
    ++packing.closed;
    auto& sum = sums[sector_of(spheres.position[k], core.axis, blocks)];
    sum[solid] += cell.solid_fraction * cell.volume;
    sum[space] += cell.volume;
  }
  packing.solid_fraction = of_sums(sums, [](const Sums& sum) { return sum[solid] / sum[space]; });
  packing.coordination = of_sums(sums, [](const Sums& sum) { return sum[ends] / sum[all]; });
  packing.without_rattlers = of_sums(sums, [](const Sums& sum) { return sum[kept_ends] / sum[kept]; });
  packing.rattlers = of_sums(sums, [](const Sums& sum) { return 1.0 - sum[kept] / sum[all]; }).mean;
  for (std::size_t q = 0; q < packing.connectivity.size(); ++q) {
    packing.connectivity[q] = of_sums(sums, [q](const Sums& sum) { return sum[with_0 + q] / sum[all]; }).mean;
  }
  return packing;
}

double sphere_volume_below(double radius, double height) {
  const double h = std::clamp(height, -radius, radius);
  return std::numbers::pi * squared(h + radius) * (2.0 * radius - h) / 3.0;
}

RadialSolidFraction radial_solid_fraction(const Spheres& spheres, const PackingCore& core, double width) {
  REPOSE_ASSERT(std::isfinite(core.radius) && width > 0.0);
  static const auto columns = columns_of_sphere();
  const auto rings = static_cast<std::size_t>(std::max(1.0, std::ceil(core.radius / width - 1e-9)));
  const double ring_width = core.radius / static_cast<double>(rings);
  std::vector<double> solid(rings, 0.0);
  std::vector<double> lengths(columns.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto& centre = spheres.position[k];
    const double radius = spheres.radius[k];
    const double volume =
        sphere_volume_below(radius, core.high - centre[2]) - sphere_volume_below(radius, core.low - centre[2]);
    const Vec<2> from_axis = Vec<2>{{centre[0], centre[1]}} - core.axis;
    if (!(volume > 0.0) || magnitude(from_axis) - radius >= core.radius) continue;
    double sum = 0.0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double top = std::min(core.high, centre[2] + columns[c].half * radius);
      const double bottom = std::max(core.low, centre[2] - columns[c].half * radius);
      lengths[c] = std::max(0.0, top - bottom);
      sum += lengths[c];
    }
    if (!(sum > 0.0)) continue;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double place =
          std::hypot(from_axis[0] + columns[c].x * radius, from_axis[1] + columns[c].y * radius) / ring_width;
      if (place < static_cast<double>(rings)) solid[static_cast<std::size_t>(place)] += volume * lengths[c] / sum;
    }
  }
  RadialSolidFraction result;
  for (std::size_t k = 0; k < rings; ++k) {
    const double inner = static_cast<double>(k) * ring_width;
    const double area = std::numbers::pi * ring_width * (2.0 * inner + ring_width);
    result.radius.push_back(inner + 0.5 * ring_width);
    result.value.push_back(solid[k] / (area * (core.high - core.low)));
  }
  return result;
}

}  // namespace repose
