// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/heap_zones.hpp"

#include "repose/results/registry.hpp"

namespace repose {

/// Densities and stresses of parts of a heap.
void add_heap_zones(Registry& to) {
  const auto zone = [](auto member) {
    return [=](const Measured& run) -> std::optional<double> {
      const auto zones = heap_zones(run.results.heap, run.results.fields, run.results.base_height);
      if (!zones) return std::nullopt;
      return (*zones).*member;
    };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("zones", "",
              "parts of a heap: a column below the apex, 0.3 half-widths wide, and flanks from 0.3 to 0.7 half-widths "
              "beside it",
              [](const Measured& run) {
                const auto zones = heap_zones(run.results.heap, run.results.fields, run.results.base_height);
                return zones ? std::optional(Object{}) : std::nullopt;
              }));
  add(measure("zones.middle_solid_fraction", "", "below the apex, from 0.4 to 0.6 of its height",
              zone(&HeapZones::middle_solid_fraction)));
  add(measure("zones.lower_solid_fraction", "", "below the apex, from 0.1 to 0.3 of its height",
              zone(&HeapZones::lower_solid_fraction)));
  add(measure("zones.middle_looser", "", "lower less middle solid fraction",
              [](const Measured& run) -> std::optional<double> {
                const auto zones = heap_zones(run.results.heap, run.results.fields, run.results.base_height);
                if (!zones) return std::nullopt;
                return zones->lower_solid_fraction - zones->middle_solid_fraction;
              }));
  add(measure("zones.stress_inclination_deg", "deg",
              "of the major principal stress of the flanks from the horizontal, outwards and down",
              zone(&HeapZones::stress_inclination_deg)));
  add(measure("zones.steeper_than_surface_deg", "deg", "that less the mean angle of repose",
              zone(&HeapZones::steeper_than_surface_deg)));
}

}  // namespace repose
