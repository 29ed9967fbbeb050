// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/core_region.hpp"

#include <cmath>
#include <numbers>
#include <unordered_map>

namespace repose {

CoreRegion measure_core(const Grains<2>& grains, const Contacts<2>& contacts, const HeapShape& heap,
                        const std::vector<VoronoiCell>& cells, double base_height, double depth, double above_base,
                        double threshold) {
  CoreRegion core;
  if (heap.surface.empty()) return core;
  std::unordered_map<std::int64_t, std::size_t> place;
  for (std::size_t k = 0; k < grains.size(); ++k) place.emplace(grains.id[k], k);
  std::unordered_map<std::int64_t, std::size_t> ends;
  for (const auto& contact : contacts.list) {
    if (!(std::fabs(contact.normal_force) > threshold)) continue;
    ++ends[contact.first];
    if (contact.second >= 0) ++ends[contact.second];
  }
  double discs = 0.0;
  double area = 0.0;
  std::size_t contact_ends = 0;
  for (const auto& cell : cells) {
    const auto& grain = grains.line[place.at(cell.id)];
    const double height = grain.position[1] - base_height;
    if (!cell.closed || !(cell.area > 0.0) || height < above_base ||
        depth_below_surface(heap, grain.position[0], height) < depth)
      continue;
    ++core.grains;
    discs += std::numbers::pi * grain.radius * grain.radius;
    area += cell.area;
    if (const auto found = ends.find(cell.id); found != ends.end()) contact_ends += found->second;
  }
  if (core.grains == 0) return core;
  core.solid_fraction = discs / area;
  core.coordination = static_cast<double>(contact_ends) / static_cast<double>(core.grains);
  return core;
}

}  // namespace repose
