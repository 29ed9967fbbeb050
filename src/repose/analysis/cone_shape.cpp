// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/cone_shape.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace repose {

namespace {

constexpr double lowest_used = 0.1;
constexpr double highest_used = 0.9;
constexpr double highest_end = 0.5;  // of a heap, over the height of its apex
constexpr std::size_t sectors = ConeRing::sectors;
constexpr long most_surface_rings = 1'000'000;  // a grain far away lies in none

/// The number of patches of a ring along each sector.
long patches_across(long ring) {
  const double arc = 2.0 * std::numbers::pi * (static_cast<double>(ring) + 0.5) / static_cast<double>(sectors);
  return std::max(1L, std::lround(arc));
}

Vec<2> centre_of(const Grains<3>& grains, const std::vector<bool>& in_heap) {
  double mass = 0.0;
  Vec<2> sum{};
  for (const auto k : by_id(grains)) {
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    mass += grain.mass;
    sum += Vec<2>{{grain.position[0], grain.position[1]}} * grain.mass;
  }
  return mass > 0.0 ? sum * (1.0 / mass) : sum;
}

/// The highest grain tops of each ring, patch by patch; negative without a grain.
using Tops = std::vector<std::vector<double>>;

Tops find_tops(const Grains<3>& grains, const std::vector<bool>& in_heap, const Vec<2>& axis, double base_height,
               double ring_width) {
  std::unordered_map<long, std::vector<double>> found;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    const double x = grain.position[0] - axis[0];
    const double y = grain.position[1] - axis[1];
    const double place = std::hypot(x, y) / ring_width;
    if (!(place < static_cast<double>(most_surface_rings))) continue;
    const auto ring = static_cast<long>(place);
    const long patches = patches_across(ring) * static_cast<long>(sectors);
    auto& tops = found.try_emplace(ring, static_cast<std::size_t>(patches), -1.0).first->second;
    double turn = std::atan2(y, x) / (2.0 * std::numbers::pi);
    if (turn < 0.0) turn += 1.0;
    const long patch = std::min(patches - 1, static_cast<long>(turn * static_cast<double>(patches)));
    auto& top = tops[static_cast<std::size_t>(patch)];
    top = std::max(top, grain.position[2] + grain.radius - base_height);
  }
  Tops tops;
  for (long ring = 0; found.contains(ring); ++ring) tops.push_back(std::move(found[ring]));
  return tops;
}

/// Mean of the tops with a grain; NaN without any.
double mean_top(const std::vector<double>& tops, std::size_t first, std::size_t last) {
  double sum = 0.0;
  double count = 0.0;
  for (auto k = first; k < last; ++k) {
    if (tops[k] < 0.0) continue;
    sum += tops[k];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : no_number;
}

/// Least-squares line through (radius, height); none through fewer than two points.
std::optional<FlankLine> fit(const std::vector<std::pair<double, double>>& points) {
  if (points.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  double sum_r = 0.0;
  double sum_h = 0.0;
  for (const auto& [r, h] : points) {
    sum_r += r;
    sum_h += h;
  }
  double srr = 0.0;
  double srh = 0.0;
  for (const auto& [r, h] : points) {
    srr += squared(r - sum_r / n);
    srh += (r - sum_r / n) * (h - sum_h / n);
  }
  const double slope = srh / srr;
  return FlankLine{slope, sum_h / n - slope * sum_r / n, std::atan(-slope) * degrees_per_radian};
}

/// The line through the rings at used heights; `height_of` gives the height of a ring, NaN where it has none.
template <class HeightOf>
std::optional<FlankLine> line_of(const ConicalHeap& cone, const HeightOf& height_of) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 1; k < cone.surface.size(); ++k) {
    const double height = height_of(cone.surface[k]);
    const double relative = height / cone.apex_height;
    if (relative >= lowest_used && relative <= highest_used) points.emplace_back(cone.surface[k].radius, height);
  }
  return fit(points);
}

/// Whether the surface falls in all sectors, as that of a heap, and not only to the wall of a silo, as a rough bed may.
/// A sector that ends one ring before the others has fallen: rings may be as wide as a small heap is steep.
bool falls_off(const ConicalHeap& cone) {
  for (std::size_t sector = 0; sector < sectors; ++sector) {
    double end = no_number;
    std::size_t rings = 0;  // up to the end
    for (std::size_t k = 0; k < cone.surface.size(); ++k) {
      if (std::isnan(cone.surface[k].sector_height[sector])) continue;
      end = cone.surface[k].sector_height[sector];
      rings = k + 1;
    }
    if (rings + 1 == cone.surface.size()) continue;
    if (!(end < highest_end * cone.apex_height)) return false;
  }
  return true;
}

std::optional<double> moments_angle(const Grains<3>& grains, const std::vector<bool>& in_heap, const Vec<2>& axis,
                                    double base_height) {
  double z = 0.0;
  double r = 0.0;
  for (const auto k : by_id(grains)) {
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    z += grain.mass * (grain.position[2] - base_height);
    r += grain.mass * std::hypot(grain.position[0] - axis[0], grain.position[1] - axis[1]);
  }
  if (r == 0.0) return std::nullopt;
  return std::atan2(2.0 * z, r) * degrees_per_radian;
}

}  // namespace

ConicalHeap measure_cone(const Grains<3>& grains, const std::vector<bool>& in_heap, double base_height,
                         double ring_width, const std::optional<Vec<2>>& axis) {
  ConicalHeap cone;
  cone.angle_deg = mean_of({});
  if (std::none_of(in_heap.begin(), in_heap.end(), [](bool is_in) { return is_in; })) return cone;
  cone.axis = axis ? *axis : centre_of(grains, in_heap);
  const auto tops = find_tops(grains, in_heap, cone.axis, base_height, ring_width);
  for (const auto& ring : tops) {
    for (const double top : ring) cone.apex_height = std::max(cone.apex_height, top);
  }
  for (std::size_t k = 0; k < tops.size(); ++k) {
    ConeRing ring;
    ring.radius = (static_cast<double>(k) + 0.5) * ring_width;
    ring.height = mean_top(tops[k], 0, tops[k].size());
    const auto across = tops[k].size() / sectors;
    for (std::size_t sector = 0; sector < sectors; ++sector) {
      ring.sector_height[sector] = mean_top(tops[k], sector * across, (sector + 1) * across);
    }
    const double relative = ring.height / cone.apex_height;
    ring.used = k > 0 && relative >= lowest_used && relative <= highest_used;
    cone.surface.push_back(ring);
  }
  if (!falls_off(cone)) {
    for (auto& ring : cone.surface) ring.used = false;
    return cone;
  }
  cone.line = line_of(cone, [](const ConeRing& ring) { return ring.height; });
  std::vector<double> angles;
  for (std::size_t sector = 0; sector < sectors; ++sector) {
    auto& line = cone.sector_lines[sector];
    line = line_of(cone, [sector](const ConeRing& ring) { return ring.sector_height[sector]; });
    if (line) angles.push_back(line->angle_deg);
  }
  cone.angle_deg = mean_of(angles);
  cone.moments_angle_deg = moments_angle(grains, in_heap, cone.axis, base_height);
  return cone;
}

double depth_below_surface(const ConicalHeap& cone, double radius, double height) {
  const auto& surface = cone.surface;
  if (surface.empty()) return -height;
  const auto outer = std::lower_bound(surface.begin(), surface.end(), radius,
                                      [](const ConeRing& ring, double place) { return ring.radius < place; });
  double top = 0.0;
  if (outer == surface.begin()) {
    top = surface.front().height;
  } else if (outer == surface.end()) {
    top = surface.back().height;
  } else {
    const auto inner = std::prev(outer);
    top = inner->height + (outer->height - inner->height) * (radius - inner->radius) / (outer->radius - inner->radius);
  }
  return (top - height) * (cone.line ? std::cos(radians(cone.line->angle_deg)) : 1.0);
}

}  // namespace repose
