// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/output.hpp"

#include "repose/scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>

namespace repose {

namespace {

void stop_keys(StopKeys& stop, Parameters& keys) {
  keys.optional_number("stop.at_rest", stop.at_rest, {"", "none"}, positive, "",
                       "ends the run after the last grain, load and wall have come, opened or begun to move, once "
                       "kinetic energy (in m g d) and net force (in m g) of every grain have been below this for "
                       "output.window; without gravity the mean normal force of the contacts replaces m g");
  keys.optional_number("stop.time", stop.time, {"", "none"}, positive, "T", "ends the run at this time");
}

void file_keys(Scene& scene, Parameters& keys) {
  auto& output = scene.output;
  const auto traits = scene.method->traits();
  const bool in_time = traits.follows_time;
  const auto unit = traits.time_unit();
  const double fall = scene.gravity > 0.0 ? std::sqrt(scene.grains.diameter / scene.gravity) : 1.0;
  // Where time counts discs, one row at the end tells all.
  const auto all = static_cast<double>(scene.source->released());
  keys.number("output.series", output.series,
              in_time ? Default{fall, "sqrt(d/g); 1 without gravity"} : Default{all, "all"},
              in_time ? positive : at_least_one, unit, "interval between rows of the time series");
  keys.number("output.frames", output.frames,
              in_time ? Default{100.0 * fall, "100 sqrt(d/g); 100 without gravity"} : Default{0.0}, not_negative, unit,
              "interval between saved frames; 0: none");
  if (in_time) {
    keys.number("output.window", output.window, {10.0 * fall, "10 sqrt(d/g); 10 without gravity"}, positive, unit,
                "interval at the end over which base forces are averaged");
    if (traits.has_forces()) {
      keys.integer("output.slices", output.slices, {.low = 2, .high = 1000},
                   scene.dimension == 2
                       ? "slices of equal disc area in which the time series follows a column between two upright walls"
                       : "slices of equal volume of spheres in which the time series follows a column in an upright "
                         "cylinder");
    }
    keys.number("output.track", output.track, not_negative, unit,
                "interval between moments at which the place of every grain is kept, for avalanches; 0: none");
  } else {
    output.window = all;
  }
  keys.number("output.checkpoint", output.checkpoint, not_negative, "s of wall time",
              "interval between checkpoints, from which a run resumes after a crash; 0: only when it is interrupted");
  if (traits.keeps_energy) {
    keys.flag("output.energy", output.energy,
              "keep the energy budget in a series of its own; a slower kernel, which gives the same bits");
  }
}

void surface_keys(Scene& scene, Parameters& keys) {
  keys.number("analysis.bin_width", scene.analysis.bin_width, {2.0 * scene.grains.diameter, "2 d"}, positive, "L",
              "bin width of the surface profile");
}

void force_keys(Scene& scene, Parameters& keys) {
  auto& analysis = scene.analysis;
  const double d = scene.grains.diameter;
  keys.choice("analysis.force_scale", analysis.force_scale,
              {scene.gravity > 0.0 ? "weight" : "mean", "\"weight\"; \"mean\" without gravity"},
              {{"weight", "of a nominal grain"},
               {"mean", "mean normal force of the contacts that carry one"},
               {"given", "`analysis.force`"}},
              "force unit of `analysis.force_threshold` and `analysis.burst`");
  if (analysis.force_scale == "given") {
    keys.number("analysis.force", analysis.force, required, positive, "M L/T^2", "the force unit");
  }
  keys.number("analysis.force_threshold", analysis.force_threshold, not_negative, "force units",
              "contacts with a smaller force do not count");
  if (scene.dimension == 2) {
    keys.number("analysis.base_bin", analysis.base_bin, {5.0 * d, "5 d"}, positive, "L",
                "bin width of the base profile");
    keys.number("analysis.field_width", analysis.field_width, {1.5 * d, "1.5 d"}, positive, "L",
                "standard deviation of the Gaussian that smooths stress and density");
  } else {
    keys.number("analysis.base_bin", analysis.base_bin, {2.0 * d, "2 d"}, positive, "L",
                "width of the rings in which the pressure on the base is measured");
    keys.number("analysis.base_cell", analysis.base_cell, {analysis.base_bin, "base_bin"}, positive, "L",
                "side of the square cells, the sensors, in which the forces on the base are measured");
    keys.number("analysis.field_width", analysis.field_width, {2.0 * d, "2 d"}, positive, "L",
                "width and height of the rings in which stress and density are measured");
  }
  keys.number("analysis.core_depth", analysis.core_depth, {4.0 * d, "4 d"}, not_negative, "L",
              "depth below the surface at which the core of a heap begins");
  keys.number("analysis.moved", analysis.moved, {0.5 * d, "0.5 d"}, positive, "L",
              "a grain that is displaced farther between two moments of the track has moved");
  keys.integer("analysis.avalanche", analysis.avalanche, {.low = 1}, "grains that move at once in an avalanche");
  if (scene.dimension == 2) {
    keys.flag("analysis.slips", analysis.slips,
              "find the slips of a driven wall whenever the run is analysed, as `repose analyse --slips` does once");
  }
  keys.number("analysis.burst", analysis.burst, positive, "force units times diameters",
              "kinetic energy of the heap above which a burst is counted");
}

void packing_keys(Scene& scene, Parameters& keys) {
  auto& analysis = scene.analysis;
  const auto traits = scene.method->traits();
  if (traits.follows_time) {
    const bool all_around = scene.box.periodic() && (scene.dimension == 2 || scene.box.periodic_y());
    keys.flag("analysis.packing", analysis.packing, {all_around, "true in a periodic box"},
              "measure the packing in a slab: solid fraction, contacts, fabric");
  } else {
    analysis.packing = true;
  }
  if (!*analysis.packing) return;
  keys.vector(
      "analysis.slab", analysis.slab, std::array<double, 2>{0.4, 1.4}, "",
      "edges of the slab above the base centres, or above height 0 without base grains, in mean heights of the grains");
  keys.number("analysis.contact_gap", analysis.contact_gap, traits.contact_gap, zero_to_one, "diameters",
              "grains closer than this touch");
  if (scene.dimension == 2) {
    keys.integer("analysis.direction_bins", analysis.direction_bins, {.low = 1, .high = 36'000},
                 "bins of contact directions, over 180 degrees");
  }
  keys.flag("analysis.correlations", analysis.correlations,
            scene.dimension == 2 ? "pair correlation g(r), and along x and y" : "pair correlation g(r)");
  keys.flag("analysis.structure_factor", analysis.structure_factor, "structure factor S(q)");
  if (scene.dimension == 2) {
    keys.flag("analysis.local_density", analysis.local_density, "local density by Voronoi cells");
  }
}

}  // namespace

void output_keys(Scene& scene, Parameters& keys) {
  const auto traits = scene.method->traits();
  if (traits.follows_time) stop_keys(scene.stop, keys);
  file_keys(scene, keys);
  // Deposited spheres have a surface, deposited discs none that is measured.
  if (traits.has_forces() || scene.dimension == 3) surface_keys(scene, keys);
  if (traits.has_forces()) force_keys(scene, keys);
  packing_keys(scene, keys);
}

void check_stop(const Scene& scene, Problems& problems) {
  const auto& stop = scene.stop;
  if (!stop.time && !stop.at_rest && problems.sound("stop.time") && problems.sound("stop.at_rest")) {
    problems.problem("stop", ": missing: give time, at_rest or both; the run ends at whichever comes first");
  }
}

void check_force_scale(const Scene& scene, Problems& problems) {
  if (scene.analysis.force_scale != "weight" || scene.gravity > 0.0) return;
  if (!problems.sound("analysis.force_scale") || !problems.sound("gravity")) return;
  problems.problem("analysis.force_scale",
                   " = \"weight\": needs gravity > 0; must be \"mean\", or \"given\" with analysis.force");
}

void check_analysis(const Scene& scene, Problems& problems) {
  check_slab(scene, problems);
  if (!problems.sound("grains.diameter")) return;
  const auto check_length = [&](const std::string& key, double length, double least, double most) {
    const double in_diameters = length / scene.grains.diameter;
    if (!problems.sound(key) || (in_diameters >= least && in_diameters <= most)) return;
    problems.problem(key, fmt::format(" = {}: must be from {} to {} diameters", length, least, most));
  };
  const bool forces = scene.method->traits().has_forces();
  if (forces || scene.dimension == 3) check_length("analysis.bin_width", scene.analysis.bin_width, 0.01, 1e6);
  if (!forces) return;
  check_length("analysis.base_bin", scene.analysis.base_bin, 0.01, 1e6);
  if (scene.dimension == 3) check_length("analysis.base_cell", scene.analysis.base_cell, 0.01, 1e6);
  check_length("analysis.field_width", scene.analysis.field_width, 0.05, 1e4);
}

void check_slab(const Scene& scene, Problems& problems) {
  if (!*scene.analysis.packing || !problems.sound("analysis.slab")) return;
  const auto [low, high] = scene.analysis.slab;
  // Where grains lie evenly up to the top, that is at twice their mean height.
  if (low < 0.0 || high <= low || low >= 2.0) {
    problems.problem("analysis.slab", fmt::format(" = [{}, {}]: an empty slab; must be 0 <= low < high, low < 2, in "
                                                  "mean heights of the grains",
                                                  low, high));
  }
}

}  // namespace repose
