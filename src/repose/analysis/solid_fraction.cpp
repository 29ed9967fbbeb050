// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/solid_fraction.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace repose {

namespace {

double full_area(double radius) { return std::numbers::pi * radius * radius; }

}  // namespace

double disc_area_below(double radius, double height) {
  if (height <= -radius) return 0.0;
  if (height >= radius) return full_area(radius);
  const double half_chord = std::sqrt((radius - height) * (radius + height));
  return radius * radius * (std::numbers::pi - std::acos(height / radius)) + height * half_chord;
}

double disc_area_in_quadrant(double radius, double right, double top) {
  if (right <= -radius || top <= -radius) return 0.0;
  if (right >= radius) return disc_area_below(radius, top);
  if (top >= radius) return disc_area_below(radius, right);
  if (right * right + top * top >= radius * radius) {
    // The corner is outside the disc: the two chords do not cross in it.
    if (right >= 0.0 && top >= 0.0) {
      return disc_area_below(radius, right) + disc_area_below(radius, top) - full_area(radius);
    }
    if (right >= 0.0) return disc_area_below(radius, top);
    if (top >= 0.0) return disc_area_below(radius, right);
    return 0.0;
  }
  const auto side = [&](double a) {
    return 0.5 * (a * std::sqrt((radius - a) * (radius + a)) + radius * radius * std::asin(a / radius));
  };
  return right * top + side(right) + side(top) + 0.25 * full_area(radius);
}

double disc_area_in(const Vec<2>& centre, double radius, const Rectangle& rectangle) {
  const double left = rectangle.low[0] - centre[0];
  const double right = rectangle.high[0] - centre[0];
  const double low = rectangle.low[1] - centre[1];
  const double high = rectangle.high[1] - centre[1];
  if (left >= radius || right <= -radius || low >= radius || high <= -radius) return 0.0;
  if (left <= -radius && right >= radius) {
    if (low <= -radius && high >= radius) return full_area(radius);
    return disc_area_below(radius, high) - disc_area_below(radius, low);
  }
  return disc_area_in_quadrant(radius, right, high) - disc_area_in_quadrant(radius, left, high) -
         disc_area_in_quadrant(radius, right, low) + disc_area_in_quadrant(radius, left, low);
}

Estimate solid_fraction(const Discs& discs, const Slab& slab, std::size_t blocks) {
  std::vector<std::array<double, 2>> sums(blocks, {0.0, slab.area() / static_cast<double>(blocks)});
  const auto count = static_cast<std::int64_t>(blocks);
  const double block_width = slab.box.width() / static_cast<double>(blocks);
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const auto& centre = discs.position[k];
    const double radius = discs.radius[k];
    if (centre[1] + radius <= slab.low || centre[1] - radius >= slab.high) continue;
    const auto first = static_cast<std::int64_t>(std::floor((centre[0] - radius - slab.box.x_min) / block_width));
    const auto last = static_cast<std::int64_t>(std::floor((centre[0] + radius - slab.box.x_min) / block_width));
    for (auto block = first; block <= last; ++block) {
      if (!slab.box.periodic && (block < 0 || block >= count)) continue;
      const double left = slab.box.x_min + static_cast<double>(block) * block_width;
      const double right = slab.box.x_min + static_cast<double>(block + 1) * block_width;
      const auto wrapped = static_cast<std::size_t>(((block % count) + count) % count);
      sums[wrapped][0] += disc_area_in(centre, radius, {{{left, slab.low}}, {{right, slab.high}}});
    }
  }
  return over_blocks(sums, [](const auto& sum) { return sum[0] / sum[1]; });
}

}  // namespace repose
