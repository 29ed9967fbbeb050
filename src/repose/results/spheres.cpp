// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/contact_graph.hpp"
#include "repose/analysis/discs.hpp"
#include "repose/analysis/heap.hpp"
#include "repose/record/force_unit.hpp"
#include "repose/results/base_loads.hpp"
#include "repose/results/measure.hpp"
#include "repose/results/sphere_results.hpp"
#include "repose/results/wall_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace repose {

namespace {

/// The core begins this far above the base centres: the base orders the layers below.
constexpr double core_of_cone_above_base = 2.0;  // diameters

SphereWallForces mean_forces(const Record<3>& record) {
  SphereWallForces forces;
  const auto& rows = record.series;
  const auto count = record.walls.size();
  if (rows.empty() || count == 0 || record.wall_series.size() != rows.size() * count) return forces;
  const auto window = rows_of_window(rows, record.scene.output.window);
  forces.window_start = window.start;
  forces.window_end = window.end;
  for (std::size_t w = 0; w < count; ++w) {
    SphereWallForce mean{record.walls[w].name, {}};
    for (auto row = window.first; row < rows.size(); ++row) {
      mean.force += record.wall_series[row * count + w].force * window.parts[row - window.first];
    }
    forces.walls.push_back(std::move(mean));
  }
  return forces;
}

/// Planes and upright cylinders bound cells; other walls do not, so that cells beside them are not closed.
CellWalls walls_of_cells(const Record<3>& record) {
  constexpr double straight = 1e-9;
  CellWalls walls;
  if (has(record.scene, Needs::deposition)) {
    if (!record.scene.base->of_grains()) walls.planes.push_back({{}, {{0.0, 0.0, 1.0}}});
    if (!record.scene.box.walled()) return walls;
    const auto& box = record.box;
    walls.planes.push_back({{{box.x_min, 0.0, 0.0}}, {{1.0, 0.0, 0.0}}});
    walls.planes.push_back({{{box.x_max, 0.0, 0.0}}, {{-1.0, 0.0, 0.0}}});
    walls.planes.push_back({{{0.0, box.y_min, 0.0}}, {{0.0, 1.0, 0.0}}});
    walls.planes.push_back({{{0.0, box.y_max, 0.0}}, {{0.0, -1.0, 0.0}}});
    return walls;
  }
  for (const auto& standing : record.walls) {
    const auto& wall = standing.wall;
    if (standing.open) continue;
    if (!wall.finite()) walls.planes.push_back({wall.point, wall.normal});
    const bool cylinder = wall.shape.kind == WallShape<3>::Kind::frustum &&
                          std::fabs(wall.shape.corners[0][0] - wall.shape.corners[1][0]) < straight;
    if (cylinder) walls.cylinders.push_back({wall.point, wall.normal, wall.shape.corners[0][0]});
  }
  return walls;
}

BaseRings rings_of(const Record<3>& record, const BaseLoads& base, const Vec<2>& axis) {
  if (base.loads.empty()) return {};
  BaseRingSettings settings;
  settings.axis = axis;
  settings.width = record.scene.analysis.base_bin;
  settings.area_of_load = base.area_of_load;
  return measure_base_rings(base.loads, settings);
}

ConeCore core_of(const Record<3>& record, const Results<3>& results, double threshold) {
  const auto& grains = *record.grains;
  const auto& analysis = record.scene.analysis;
  std::vector<std::size_t> touching(grains.size(), 0);
  for (const auto& contact : record.contacts.list) {
    if (!(std::fabs(contact.normal_force) > threshold)) continue;
    if (const auto first = record.grains.find(contact.first)) ++touching[*first];
    if (contact.second < 0) continue;
    if (const auto second = record.grains.find(contact.second)) ++touching[*second];
  }
  ConeCore core;
  double spheres = 0.0;
  double cells = 0.0;
  double contacts = 0.0;
  const double above = results.base_height + core_of_cone_above_base * record.scene.grains.diameter;
  for (const auto& cell : results.cells) {
    const auto& grain = grains.line[cell.place];
    const double radius = magnitude(Vec<2>{{grain.position[0], grain.position[1]}} - results.cone.axis);
    if (!cell.closed || grain.fixed() || grain.position[2] < above) continue;
    if (depth_below_surface(results.cone, radius, grain.position[2] - results.base_height) < analysis.core_depth) {
      continue;
    }
    ++core.grains;
    spheres += 4.0 / 3.0 * std::numbers::pi * std::pow(grain.radius, 3);
    cells += cell.volume;
    contacts += static_cast<double>(touching[cell.place]);
  }
  if (core.grains == 0) return core;
  core.solid_fraction = spheres / cells;
  core.coordination = contacts / static_cast<double>(core.grains);
  return core;
}

/// The block in which the structure is measured: all of a periodic side, and of an open one the part in which the
/// spheres of the slab lie.
Cuboid block_of(const Record<3>& record, const Spheres& spheres, const PackingCore& slab) {
  Cuboid block;
  block.low[2] = slab.low;
  block.high[2] = slab.high;
  const std::array<bool, 2> periodic{record.box.periodic, record.box.periodic_y};
  const std::array<double, 2> low{record.box.x_min, record.box.y_min};
  const std::array<double, 2> high{record.box.x_max, record.box.y_max};
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    block.periodic[k] = periodic[k];
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t n = 0; n < spheres.size(); ++n) {
      if (spheres.base[n] || !slab.holds(spheres.position[n])) continue;
      least = std::min(least, spheres.position[n][axis]);
      most = std::max(most, spheres.position[n][axis]);
    }
    block.low[axis] = periodic[k] ? low[k] : least;
    block.high[axis] = periodic[k] ? high[k] : most;
  }
  return block;
}

/// Upright and level planes around a packing count as neighbours.
PackingWalls packing_walls(const Record<3>& record) {
  constexpr double straight = 1e-9;
  PackingWalls walls;
  if (has(record.scene, Needs::deposition)) {
    if (!record.scene.base->of_grains()) walls.floor = 0.0;
    if (record.scene.box.walled()) {
      walls.left = record.box.x_min;
      walls.right = record.box.x_max;
      walls.front = record.box.y_min;
      walls.back = record.box.y_max;
    }
    return walls;
  }
  for (const auto& standing : record.walls) {
    const auto& wall = standing.wall;
    if (standing.open || wall.finite() || wall.smooth) continue;
    const auto along = [&](int axis) { return 1.0 - std::fabs(wall.normal[axis]) < straight; };
    if (along(2) && wall.normal[2] > 0.0) walls.floor = wall.point[2];
    if (along(0)) (wall.normal[0] > 0.0 ? walls.left : walls.right) = wall.point[0];
    if (along(1)) (wall.normal[1] > 0.0 ? walls.front : walls.back) = wall.point[1];
  }
  return walls;
}

void measure_packing_of(const Record<3>& record, Results<3>& results) {
  const auto& analysis = record.scene.analysis;
  const auto spheres = spheres_of(record.grains);
  if (deposited_count(spheres) < 2) return;
  const double mean = mean_diameter(spheres);
  const bool on_grains = record.scene.base->of_grains() || record.scene.start.base;
  const double lowest = on_grains ? 0.0 : 0.5 * mean;
  double height = 0.0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (!spheres.base[k]) height += (spheres.position[k][2] - lowest) / static_cast<double>(deposited_count(spheres));
  }
  PackingCore slab;
  slab.low = lowest + analysis.slab[0] * height;
  slab.high = lowest + analysis.slab[1] * height;
  const auto walls = packing_walls(record);
  const auto graph = contact_graph(spheres, record.box, analysis.contact_gap);
  const auto on_walls = wall_contacts(spheres, walls, analysis.contact_gap);
  results.slab = slab;
  results.packing =
      measure_sphere_packing(spheres, results.cells, graph, on_walls, rattlers(spheres, graph, on_walls), slab);
  std::vector<Vec<3>> points;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (!spheres.base[k]) points.push_back(spheres.position[k]);
  }
  const auto block = block_of(record, spheres, slab);
  const double side = std::min(block.side(0), block.side(1));
  if (analysis.correlations && side > 0.0) {
    constexpr double farthest = 6.0;  // mean diameters
    results.pair_correlation =
        sphere_pair_correlation(points, block, std::min(farthest * mean, 0.5 * side), 0.05 * mean, mean);
  }
  if (analysis.structure_factor && side > 0.0) {
    StructureFactorOptions options;
    options.largest = 4.0 * std::numbers::pi / mean;
    results.structure_factor = sphere_isotropic_structure_factor(points, block, options);
  }
}

}  // namespace

Results<3> analyse(const Record<3>& record) {
  const auto& scene = record.scene;
  const auto& grains = *record.grains;
  const auto& contacts = record.contacts;
  Results<3> results;
  const bool forces = has(scene, Needs::forces);
  // Without forces all deposited spheres lie in the packing.
  const auto in_heap = forces ? supported(grains, contacts) : std::vector<bool>(grains.size(), true);
  results.cells = sphere_cells(record.grains, in_heap, walls_of_cells(record), record.box);
  results.cone = measure_cone(grains, in_heap, results.base_height, scene.analysis.bin_width);
  if (*scene.analysis.packing) measure_packing_of(record, results);
  if (!forces) return results;
  results.force_unit = force_unit(scene, contacts);
  results.max_overlap = max_overlap(contacts);
  const double threshold = scene.analysis.force_threshold * results.force_unit;
  results.network = measure_force_network(grains, contacts, in_heap, threshold);
  results.forces = measure_force_statistics(contacts, threshold);
  results.chains = find_chains(grains, contacts, threshold, record.box);
  results.fabric = measure_contact_fabric(contacts, threshold);
  results.walls = mean_forces(record);
  results.column = measure_column_of(record);
  double mass = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) mass += grains.line[k].mass;
  }
  const double weight = mass * scene.gravity;
  if (weight > 0.0) results.weight_error = record.facts.support_force / weight - 1.0;
  const auto base = base_loads(record);
  results.base = rings_of(record, base, results.cone.axis);
  results.base_cells = measure_base_cells(base.loads, scene.analysis.base_cell, record.box);
  results.core = core_of(record, results, threshold);
  results.fields = axial_fields(record.grains, contacts, in_heap, record.box,
                                {results.cone.axis, scene.analysis.field_width, scene.analysis.field_width, 0.0});
  if (mass > 0.0 && !results.fields.density.empty()) {
    double sum = 0.0;
    for (std::size_t k = 0; k < results.fields.density.size(); ++k) {
      sum += results.fields.density[k] * results.fields.volume[k];
    }
    results.field_mass_error = sum / mass - 1.0;
  }
  if (leans_on_steep_walls(contacts, weight)) {
    results.cone.line.reset();
    results.cone.sector_lines.fill(std::nullopt);
    results.cone.angle_deg = mean_of({});
    results.cone.moments_angle_deg.reset();
  }
  if (!results.cone.moments_angle_deg) results.base.dip_index.reset();  // a bed has no apex
  return results;
}

}  // namespace repose
