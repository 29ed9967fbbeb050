// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/local_density.hpp"

#include "repose/analysis/voronoi.hpp"
#include "repose/core/grains.hpp"

#include <algorithm>
#include <numbers>

namespace repose {

namespace {

constexpr double first_cut_off = 1.5;   // [largest diameters]
constexpr double second_cut_off = 6.0;  // [largest diameters] for cells beside large voids

/// All discs that can bound a cell of the slab, as fixed grains, because fixed grains bound cells whether or not they
/// have a cell themselves. Their ids are indices in `discs`.
Grains<2> surroundings(const Discs& discs, const Slab& slab) {
  const double largest = *std::max_element(discs.radius.begin(), discs.radius.end());
  // A radical line lies half way between two discs; corners of the cut-off lie a little farther out.
  const double margin = 2.0 * second_cut_off * 2.0 * largest * 1.1;
  Grains<2> grains;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const double y = discs.position[k][1];
    if (y < slab.low - margin || y > slab.high + margin) continue;
    Grain<2> grain;
    grain.position = discs.position[k];
    grain.radius = discs.radius[k];
    grains.add(grain, static_cast<std::int64_t>(k));
  }
  return grains;
}

}  // namespace

LocalDensity local_density(const Discs& discs, const Slab& slab, std::size_t bins) {
  LocalDensity result;
  const OrderedGrains<2> grains{surroundings(discs, slab), slab.box};
  std::vector<bool> wanted(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto disc = static_cast<std::size_t>(grains->id[k]);
    wanted[k] = !discs.base[disc] && slab.holds(discs.position[disc]);
  }
  std::vector<FlatWall> walls;
  if (!slab.box.periodic) {
    walls.push_back({{{slab.box.x_min, 0.0}}, {{1.0, 0.0}}});
    walls.push_back({{{slab.box.x_max, 0.0}}, {{-1.0, 0.0}}});
  }

  std::vector<double> densities;
  double disc_area = 0.0;
  double cell_area = 0.0;
  for (const double cut_off : {first_cut_off, second_cut_off}) {
    // The cells are ordered by ascending id, as the grains are.
    const auto cells = voronoi(grains, wanted, walls, slab.box, cut_off);
    std::size_t k = 0;
    for (const auto& cell : cells) {
      while (grains->id[k] != cell.id) ++k;
      if (!cell.closed || !(cell.area > 0.0)) continue;
      wanted[k] = false;
      densities.push_back(cell.solid_fraction);
      disc_area += std::numbers::pi * squared(grains->line[k].radius);
      cell_area += cell.area;
    }
    if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) break;
  }
  result.cells = densities.size();
  result.open = static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), true));
  result.density = mean_of(densities);
  result.solid_fraction = disc_area / cell_area;
  result.bin_width = 1.0 / static_cast<double>(bins);
  result.count.assign(bins, 0);
  for (const double density : densities) {
    ++result.count[std::min(bins - 1, static_cast<std::size_t>(density * static_cast<double>(bins)))];
  }
  for (std::size_t k = 0; k < bins; ++k) {
    result.centre.push_back((static_cast<double>(k) + 0.5) * result.bin_width);
    result.probability.push_back(static_cast<double>(result.count[k]) /
                                 (static_cast<double>(densities.size()) * result.bin_width));
  }
  return result;
}

}  // namespace repose
