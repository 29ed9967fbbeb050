// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/key_groups.hpp"

#include <cmath>

namespace repose {

namespace {

void packing_keys(Scene& scene, Keys& keys) {
  auto& analysis = scene.analysis;
  if (scene.method.deposits()) {
    analysis.packing = true;
  } else {
    keys.flag("analysis.packing", analysis.packing, scene.box.x == "periodic",
              "measure the packing in a slab: solid fraction, contacts, fabric");
  }
  if (!analysis.packing) return;
  keys.vector("analysis.slab", analysis.slab, std::array<double, 2>{0.4, 1.4}, "",
              "edges of the slab above the base centres, over the mean height of the grains");
  // A step of contact dynamics ends with gaps of the size of its residual.
  keys.number("analysis.contact_gap", analysis.contact_gap, scene.method.rigid() ? 5e-4 : 1e-9, not_negative,
              "diameters", "grains closer than this touch");
  keys.integer("analysis.direction_bins", analysis.direction_bins, 36, 1, "of contact directions, over 180 degrees");
  keys.flag("analysis.correlations", analysis.correlations, false, "pair correlation g(r), and along x and y");
  keys.flag("analysis.structure_factor", analysis.structure_factor, false, "S(q)");
  keys.flag("analysis.local_density", analysis.local_density, false, "by Voronoi cells");
}

/// Time counts discs there, and one row of the series at the end says it all.
void deposition_run_keys(Scene& scene, Keys& keys) {
  const auto all = static_cast<double>(scene.source.count);
  keys.number("output.series", scene.output.series, all, {.low = 1.0}, "discs", "between rows of the time series");
  keys.number("output.frames", scene.output.frames, 0.0, not_negative, "discs", "between saved frames; 0: none");
  keys.number("output.checkpoint", scene.output.checkpoint, 60.0, not_negative, "s of wall time",
              "between checkpoints, from which a run that was cut off goes on; 0: only when it is interrupted");
  scene.output.window = all;
  packing_keys(scene, keys);
}

}  // namespace

void run_keys(Scene& scene, Keys& keys) {
  if (scene.method.deposits()) return deposition_run_keys(scene, keys);
  const double d = scene.grains.diameter;
  const double time_unit = scene.gravity > 0.0 ? std::sqrt(d / scene.gravity) : 1.0;
  keys.optional_number("stop.at_rest", scene.stop.at_rest, "", positive, "",
                       "after the last grain, once kinetic energy per grain (in m g d) and force residual are below");
  keys.optional_number("stop.time", scene.stop.time, "", positive, "T", "latest end");
  keys.number("output.series", scene.output.series, time_unit, positive, "T", "between rows of the time series");
  keys.number("output.frames", scene.output.frames, 100.0 * time_unit, not_negative, "T",
              "between saved frames; 0: none");
  keys.number("output.window", scene.output.window, 10.0 * time_unit, positive, "T",
              "at the end, over which base forces are averaged");
  keys.number("output.track", scene.output.track, 0.0, not_negative, "T",
              "between moments at which the place of every grain is kept, for avalanches; 0: none");
  keys.number("output.checkpoint", scene.output.checkpoint, 60.0, not_negative, "s of wall time",
              "between checkpoints, from which a run that was cut off goes on; 0: only when it is interrupted");
  if (!scene.method.rigid()) {
    keys.flag("output.energy", scene.output.energy, false,
              "keep account of the energy, a series of its own; in a slower kernel that gives the same bits");
  }
  keys.number("analysis.bin_width", scene.analysis.bin_width, 2.0 * d, positive, "L", "of the surface profile");
  keys.number("analysis.force_threshold", scene.analysis.force_threshold, 0.2, not_negative, "grain weights",
              "contacts that carry less do not count");
  keys.number("analysis.base_bin", scene.analysis.base_bin, 5.0 * d, positive, "L", "of the binned base profile");
  keys.number("analysis.field_width", scene.analysis.field_width, 1.5 * d, positive, "L",
              "standard deviation of the Gaussian that smooths stress and density");
  keys.number("analysis.core_depth", scene.analysis.core_depth, 4.0 * d, not_negative, "L",
              "below the surface, where the core of a heap begins");
  keys.number("analysis.moved", scene.analysis.moved, 0.5 * d, positive, "L",
              "a grain that goes farther between two moments of the track has moved");
  keys.integer("analysis.avalanche", scene.analysis.avalanche, 10, 1, "grains that move at once in an avalanche");
  keys.number("analysis.burst", scene.analysis.burst, 5.0, positive, "grain weights times diameters",
              "kinetic energy of the heap above which a burst is counted");
  packing_keys(scene, keys);
}

}  // namespace repose
