// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/heap.hpp"

#include "repose/core/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

namespace repose {

namespace {

constexpr double lowest_used = 0.1;
constexpr double highest_used = 0.9;
constexpr double highest_end = 0.5;  // of a heap, over the height of its apex

/// Least-squares line through the used bins of surface[first..last); `outward` is -1 on the left flank, +1 on the
/// right.
std::optional<FlankLine> fit(const std::vector<SurfaceBin>& surface, std::size_t first, std::size_t last,
                             double outward) {
  double n = 0.0;
  double sum_x = 0.0;
  double sum_h = 0.0;
  for (auto k = first; k < last; ++k) {
    if (!surface[k].used) continue;
    n += 1.0;
    sum_x += surface[k].x;
    sum_h += surface[k].height;
  }
  if (n < 2.0) return std::nullopt;
  double sxx = 0.0;
  double sxh = 0.0;
  for (auto k = first; k < last; ++k) {
    if (!surface[k].used) continue;
    sxx += std::pow(surface[k].x - sum_x / n, 2);
    sxh += (surface[k].x - sum_x / n) * (surface[k].height - sum_h / n);
  }
  const double slope = sxh / sxx;
  return FlankLine{slope, sum_h / n - slope * sum_x / n, std::atan(-outward * slope) * degrees_per_radian};
}

template <int D>
std::optional<double> moments_angle(const Grains<D>& grains, const std::vector<bool>& in_heap, double base_height) {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    n += 1.0;
    x += grains.line[k].position[0];
    y += grains.line[k].position[up<D>] - base_height;
  }
  if (n == 0.0) return std::nullopt;
  double spread = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) spread += std::fabs(grains.line[k].position[0] - x / n);
  }
  if (spread == 0.0) return std::nullopt;
  return std::atan2(y, spread) * degrees_per_radian;
}

/// Whether the surface falls to both sides, as that of a heap, and not only to the walls of a silo or pipe.
bool falls_off(const HeapShape& shape) {
  const double low = highest_end * shape.apex_height;
  return shape.surface.front().height < low && shape.surface.back().height < low;
}

}  // namespace

double depth_below_surface(const HeapShape& heap, double x, double height) {
  const auto& surface = heap.surface;
  const auto right = std::lower_bound(surface.begin(), surface.end(), x,
                                      [](const SurfaceBin& bin, double place) { return bin.x < place; });
  double top = 0.0;
  if (right == surface.begin()) {
    top = surface.front().height;
  } else if (right == surface.end()) {
    top = surface.back().height;
  } else {
    const auto left = std::prev(right);
    top = left->height + (right->height - left->height) * (x - left->x) / (right->x - left->x);
  }
  const auto& flank = x < heap.apex_x ? heap.left : heap.right;
  return (top - height) * (flank ? std::cos(flank->angle_deg / degrees_per_radian) : 1.0);
}

template <int D>
std::vector<bool> supported(const Grains<D>& grains, const Contacts<D>& contacts) {
  std::unordered_map<std::int64_t, std::size_t> place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], k);
  std::vector<bool> touching(grains.size(), false);
  for (const auto& contact : contacts.list) {
    touching[place.at(contact.first)] = true;
    if (contact.second >= 0) touching[place.at(contact.second)] = true;
  }
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto& grain = grains.line[k];
    // The last state of a failed run may hold grains whose position is not a number.
    if (grain.fixed() || !std::isfinite(magnitude(grain.position))) touching[k] = false;
  }
  return touching;
}

template <int D>
bool leans_on_steep_walls(const Contacts<D>& contacts, double weight) {
  constexpr double steep = 0.7071;
  double force = 0.0;
  for (const auto& contact : contacts.list) {
    if (contact.second < 0 && std::fabs(contact.normal[up<D>]) < steep) force += std::fabs(contact.normal_force);
  }
  return force > 0.01 * weight;
}

template <int D>
HeapShape measure_heap(const Grains<D>& grains, const std::vector<bool>& in_heap, double base_height,
                       double bin_width) {
  std::map<long, double> highest;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!in_heap[k]) continue;
    const auto& grain = grains.line[k];
    const double top = grain.position[up<D>] + grain.radius - base_height;
    const auto bin = static_cast<long>(std::floor(grain.position[0] / bin_width));
    const auto [entry, is_new] = highest.emplace(bin, top);
    if (!is_new) entry->second = std::max(entry->second, top);
  }
  HeapShape shape;
  if (highest.empty()) return shape;
  const auto apex = std::max_element(highest.begin(), highest.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  shape.apex_x = (static_cast<double>(apex->first) + 0.5) * bin_width;
  shape.apex_height = apex->second;

  auto first = apex;
  while (first != highest.begin() && std::prev(first)->first == first->first - 1) --first;
  auto last = std::next(apex);
  while (last != highest.end() && last->first == std::prev(last)->first + 1) ++last;
  std::size_t apex_place = 0;
  for (auto bin = first; bin != last; ++bin) {
    if (bin == apex) apex_place = shape.surface.size();
    const double relative = bin->second / shape.apex_height;
    shape.surface.push_back({(static_cast<double>(bin->first) + 0.5) * bin_width, bin->second,
                             bin != apex && relative >= lowest_used && relative <= highest_used});
  }
  shape.left = fit(shape.surface, 0, apex_place, -1.0);
  shape.right = fit(shape.surface, apex_place + 1, shape.surface.size(), 1.0);
  if (falls_off(shape)) shape.moments_angle_deg = moments_angle(grains, in_heap, base_height);
  return shape;
}

template std::vector<bool> supported(const Grains<2>&, const Contacts<2>&);
template std::vector<bool> supported(const Grains<3>&, const Contacts<3>&);
template bool leans_on_steep_walls(const Contacts<2>&, double);
template bool leans_on_steep_walls(const Contacts<3>&, double);
template HeapShape measure_heap(const Grains<2>&, const std::vector<bool>&, double, double);
template HeapShape measure_heap(const Grains<3>&, const std::vector<bool>&, double, double);

}  // namespace repose
