// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/results.hpp"

#include "repose/analysis/base_lines.hpp"
#include "repose/analysis/sticking_rule.hpp"
#include "repose/record/force_unit.hpp"
#include "repose/results/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace repose {

namespace {

/// The core begins this far above the base centres: the base orders the layers below.
constexpr double core_above_base = 2.0;  // diameters

/// Fields end at walls as they stand, and at rows of fixed grains.
FieldSettings field_settings(const Record<2>& record, double threshold) {
  FieldSettings settings{record.scene.analysis.field_width, threshold, standing_walls(record.walls)};
  const auto base = base_lines(record.grains, record.box);
  settings.walls.insert(settings.walls.end(), base.begin(), base.end());
  return settings;
}

MotionSettings motion_settings(const Scene& scene, double base_height, double burst) {
  MotionSettings settings;
  settings.moved = scene.analysis.moved;
  settings.least = static_cast<std::size_t>(scene.analysis.avalanche);
  settings.burst = burst;
  settings.base_height = base_height;
  settings.bin_width = scene.analysis.bin_width;
  return settings;
}

/// The smallest box around the centres of the grains that move.
struct Extent {
  Vec<2> low{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
  Vec<2> high{{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};
};

Extent extent_of(const Discs& discs) {
  Extent extent;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    if (discs.base[k]) continue;
    for (int axis = 0; axis < 2; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], discs.position[k][axis]);
      extent.high[axis] = std::max(extent.high[axis], discs.position[k][axis]);
    }
  }
  return extent;
}

/// Upright walls at the sides of all grains, and a level one below them, hold a packing. A piece of wall holds it if
/// the grains do not reach past its ends.
PackingWalls walls_around(const Record<2>& record, const Extent& grains) {
  constexpr double straight = 1e-9;
  PackingWalls walls;
  const auto nearest = [](std::optional<double>& side, double place, double towards) {
    if (!side || (place - *side) * towards > 0.0) side = place;
  };
  for (const auto& standing : record.walls) {
    const auto& wall = standing.wall;
    if (standing.open || wall.smooth) continue;
    const auto spans = [&](int axis) {
      return wall.point[axis] - wall.half_length <= grains.low[axis] &&
             wall.point[axis] + wall.half_length >= grains.high[axis];
    };
    if (std::fabs(wall.normal[1]) < straight && spans(1)) {
      if (wall.point[0] < grains.low[0]) nearest(walls.left, wall.point[0], 1.0);
      if (wall.point[0] > grains.high[0]) nearest(walls.right, wall.point[0], -1.0);
    }
    if (std::fabs(wall.normal[0]) < straight && spans(0) && wall.point[1] < grains.low[1])
      nearest(walls.floor, wall.point[1], 1.0);
  }
  return walls;
}

/// The box between the walls at the sides of the grains.
Box<2> box_between(Box<2> box, const PackingWalls& walls) {
  if (box.periodic) return box;
  if (walls.left) box.x_min = std::max(box.x_min, *walls.left);
  if (walls.right) box.x_max = std::min(box.x_max, *walls.right);
  return box;
}

PackingOptions packing_options(const Record<2>& record, const Discs& discs) {
  const auto& scene = record.scene;
  const auto& analysis = scene.analysis;
  PackingOptions options;
  options.slab = {.low = analysis.slab[0], .high = analysis.slab[1], .base_height = std::nullopt};
  options.gap = analysis.contact_gap;
  options.directions = static_cast<std::size_t>(analysis.direction_bins);
  options.correlations = analysis.correlations;
  options.structure = analysis.structure_factor;
  options.local_density = analysis.local_density;
  if (!has(scene, Needs::deposition)) {
    options.walls = walls_around(record, extent_of(discs));
    // Heights count from the centres of the base grains, or from height 0.
    if (!scene.base->of_grains() && !scene.start.base) options.slab.base_height = 0.0;
    return options;
  }
  options.slab.base_height = 0.0;
  // Base discs lie on the floor too, and are neighbours already.
  options.walls.floor = -0.5 * scene.grains.diameter;
  if (scene.box.walled()) {
    options.walls.left = -scene.box.half_width;
    options.walls.right = scene.box.half_width;
  }
  return options;
}

void measure_packing(const Record<2>& record, Results<2>& results) {
  const auto& scene = record.scene;
  const auto discs = discs_of(record.grains);
  const auto options = packing_options(record, discs);
  const auto box = scene.box.walled() ? record.box : box_between(record.box, options.walls);
  auto result = analyse_packing(discs, box, options);
  results.packing = std::move(result.packing);
  results.packing_problem = std::move(result.problem);
  if (!results.packing) return;
  const auto& graph = result.graph;
  for (std::size_t k = 0; k < discs.size(); ++k) {
    results.neighbours.push_back(static_cast<std::int64_t>(graph.degree(k)));
  }
  const auto angle = scene.method->sticking_angle();
  if (!angle) return;
  results.max_overlap = deepest_overlap(discs, box, graph);
  const auto breaks = breaks_sticking_rule(discs, box, graph, options.walls, options.gap, *angle);
  results.breaking_rule = std::count(breaks.begin(), breaks.end(), 1);
}

/// The network of a packing whose contacts carry no forces: all of them count.
ForceNetwork network_of(const Packing& packing) {
  ForceNetwork network;
  network.contacts = packing.contacts;
  network.coordination = packing.coordination.mean.mean;
  network.connectivity = packing.coordination.connectivity;
  if (packing.fabric) {
    network.anisotropy = packing.fabric->all.anisotropy.mean;
    network.direction_deg = packing.fabric->folded.direction_deg.mean;
  }
  return network;
}

/// A record without forces: the packing is all there is to measure.
Results<2> analyse_packing_alone(const Record<2>& record) {
  Results<2> results;
  if (*record.scene.analysis.packing) measure_packing(record, results);
  if (results.packing) results.network = network_of(*results.packing);
  return results;
}

}  // namespace

Results<2> analyse(const Record<2>& record) {
  if (!has(record.scene, Needs::forces)) return analyse_packing_alone(record);
  const auto& scene = record.scene;
  const auto& grains = *record.grains;
  const auto& contacts = record.contacts;
  const auto& box = record.box;
  Results<2> results;
  results.force_unit = force_unit(scene, contacts);
  const double threshold = scene.analysis.force_threshold * results.force_unit;
  const auto in_heap = supported(grains, contacts);
  results.heap = measure_heap(grains, in_heap, results.base_height, scene.analysis.bin_width);
  results.network = measure_force_network(grains, contacts, in_heap, threshold);
  results.max_overlap = max_overlap(contacts);
  results.walls = mean_wall_forces(record);
  results.column = measure_column_of(record);
  results.dip = base_dip(record.base);
  if (results.dip) results.base_scatter = base_scatter(record.base, results.dip->centre, results.dip->half_width);
  results.base = binned(record.base, scene.analysis.base_bin);
  double mass = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) mass += grains.line[k].mass;
  }
  const double weight = mass * scene.gravity;
  if (weight > 0.0) results.weight_error = record.facts.support_force / weight - 1.0;

  results.cells = voronoi(record.grains, in_heap, standing_walls(record.walls), box);
  results.grain_stress = grain_stresses(record.grains, contacts, results.cells, box);
  results.core = measure_core(grains, contacts, results.heap, results.cells, results.base_height,
                              scene.analysis.core_depth, core_above_base * scene.grains.diameter, threshold);
  results.forces = measure_force_statistics(contacts, threshold);
  results.chains = find_chains(grains, contacts, threshold, box);
  results.force_lines = find_force_lines(record.grains, contacts, threshold);
  results.fields = coarse_grained(record.grains, contacts, in_heap, box, field_settings(record, threshold));
  if (mass > 0.0 && !results.fields.density.empty()) {
    double sum = 0.0;
    for (const double density : results.fields.density) sum += density;
    results.field_weight_error = sum * results.fields.cell * results.fields.cell / mass - 1.0;
  }
  results.motion = measure_motion(
      record.track, box, motion_settings(scene, results.base_height, burst_threshold(scene, results.force_unit)));
  if (*scene.analysis.packing) measure_packing(record, results);
  // The core above lies below these lines, whatever holds them.
  if (leans_on_steep_walls(contacts, weight)) {
    results.heap.left.reset();
    results.heap.right.reset();
    results.heap.moments_angle_deg.reset();
  }
  return results;
}

}  // namespace repose
