// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/packing.hpp"

#include "repose/analysis/solid_fraction.hpp"

#include <cmath>
#include <numbers>

namespace repose {

namespace {

PackingSurface measure_surface(const Discs& discs, const Box<2>& box, double column) {
  PackingSurface surface;
  surface.profile = surface_profile(discs, box, column);
  surface.roughness = roughness(surface.profile);
  surface.scaling = roughness_scaling(surface.profile, usual_windows(surface.profile));
  surface.growth = surface_growth(discs, box, column, usual_numbers(discs, box, column));
  return surface;
}

IsotropicStructureFactor measure_structure(const Discs& discs, const Slab& slab, StructureFactorOptions options) {
  if (!(options.largest > 0.0)) options.largest = 4.0 * std::numbers::pi / mean_diameter(discs);
  std::vector<Vec<2>> centres;
  for (const auto k : centres_in(discs, slab)) centres.push_back(discs.position[k]);
  return isotropic_structure_factor(centres, slab, options);
}

}  // namespace

PackingResult analyse_packing(const Discs& discs, const Box<2>& box, const PackingOptions& options) {
  const bool right = options.gap >= 0.0 && options.column > 0.0 && options.pair_correlation.bin_width > 0.0 &&
                     options.pair_correlation.strip > 0.0;
  if (!right) return {{}, "gap must be >= 0; column, bin_width and strip must be > 0", {}};
  if (options.blocks == 0 || options.directions == 0 || options.density_bins == 0) {
    return {{}, "blocks, directions and density_bins must be at least 1", {}};
  }
  auto found = find_slab(discs, box, options.slab);
  if (!found.slab) return {{}, std::move(found.problem), {}};
  const Slab& slab = *found.slab;

  Packing packing;
  packing.slab = slab;
  packing.discs = deposited_count(discs);
  packing.solid_fraction = solid_fraction(discs, slab, options.blocks);
  auto graph = contact_graph(discs, box, options.gap);
  const auto on_walls = wall_contacts(discs, options.walls, options.gap);
  const auto loose = rattlers(discs, graph, on_walls);
  packing.contacts = graph.contacts();
  packing.coordination = measure_coordination(discs, graph, on_walls, loose, slab, options.blocks);
  packing.fabric = measure_fabric(discs, graph, slab, options.directions, options.blocks);
  packing.regime = regime_of(packing.solid_fraction.mean);
  packing.regime_by_structure = regime_of(packing.coordination.connectivity, packing.coordination.mean.mean);
  if (options.surface) packing.surface = measure_surface(discs, box, options.column * mean_diameter(discs));
  if (options.correlations) packing.pair_correlation = pair_correlation(discs, slab, options.pair_correlation);
  if (options.structure) packing.structure_factor = measure_structure(discs, slab, options.structure_factor);
  if (options.local_density) packing.local_density = local_density(discs, slab, options.density_bins);
  return {std::move(packing), {}, std::move(graph)};
}

}  // namespace repose
