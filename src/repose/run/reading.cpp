// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run/reading.hpp"

#include "repose/run/setup.hpp"

namespace repose {

namespace {

/// The core begins this far above the base centres: the base orders the layers below.
constexpr double core_above_base = 2.0;  // diameters

std::vector<Edge> edges_of(const Scene& scene) {
  std::vector<Edge> edges;
  for (const auto& plane : make_walls(scene)) edges.push_back({plane.point, plane.normal});
  return edges;
}

MotionSettings motion_settings(const Scene& scene, double base_height) {
  MotionSettings settings;
  settings.moved = scene.analysis.moved;
  settings.least = static_cast<std::size_t>(scene.analysis.avalanche);
  settings.burst = scene.analysis.burst * scene.grain_weight() * scene.grains.diameter;
  settings.base_height = base_height;
  settings.bin_width = scene.analysis.bin_width;
  return settings;
}

}  // namespace

Reading read(const Record& record) {
  const auto& scene = record.scene;
  const auto& grains = record.grains;
  const auto& contacts = record.contacts;
  const auto box = make_box(scene);
  const double threshold = scene.analysis.force_threshold * scene.grain_weight();
  Reading reading;
  const auto in_heap = supported(grains, contacts);
  reading.heap = read_heap(grains, in_heap, reading.base_height, scene.analysis.bin_width);
  reading.network = read_force_network(grains, contacts, in_heap, threshold);
  reading.max_overlap = max_overlap(contacts);
  reading.dip = base_dip(record.base);
  if (reading.dip) reading.base_scatter = base_scatter(record.base, reading.dip->centre, reading.dip->half_width);
  reading.base = binned(record.base, scene.analysis.base_bin);
  double mass = 0.0;
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (in_heap[k]) mass += grains.line[k].mass;
  }
  const double weight = mass * scene.gravity;
  if (weight > 0.0) reading.weight_error = record.facts.support_force / weight - 1.0;

  reading.cells = voronoi(grains, in_heap, edges_of(scene), box);
  reading.core = read_core(grains, contacts, reading.heap, reading.cells, reading.base_height,
                           scene.analysis.core_depth, core_above_base * scene.grains.diameter, threshold);
  reading.forces = read_force_statistics(contacts, threshold);
  reading.chains = read_chains(grains, contacts, threshold, box);
  reading.fields = coarse_grained(grains, contacts, in_heap, box, scene.analysis.field_width);
  if (mass > 0.0) {
    double sum = 0.0;
    for (const double density : reading.fields.density) sum += density;
    reading.field_weight_error = sum * reading.fields.cell * reading.fields.cell / mass - 1.0;
  }
  reading.motion = read_motion(record.track, box, motion_settings(scene, reading.base_height));
  return reading;
}

}  // namespace repose
