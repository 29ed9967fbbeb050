// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <limits>

namespace repose {

namespace {

using Flank = std::optional<FlankLine> HeapShape::*;

auto angle_of(Flank side) {
  return [=](const Measured& run) -> std::optional<double> {
    const auto& flank = run.results.heap.*side;
    if (!flank) return std::nullopt;
    return flank->angle_deg;
  };
}

std::optional<double> mean_angle(const Measured& run) {
  const auto& heap = run.results.heap;
  if (!heap.left || !heap.right) return std::nullopt;
  return 0.5 * (heap.left->angle_deg + heap.right->angle_deg);
}

Attribute<Measured> of_flank(const std::string& name, Flank side, double FlankLine::*member, const std::string& unit,
                             const std::string& meaning) {
  return attribute<Measured>(
      name,
      [=](const Measured& run) {
        const auto& flank = run.results.heap.*side;
        return flank ? (*flank).*member : std::numeric_limits<double>::quiet_NaN();
      },
      unit, meaning);
}

void add_surface(Registry& to) {
  const auto heap = [](auto member) { return [=](const Measured& run) { return run.results.heap.*member; }; };
  const std::string line = "of the line h = slope x + intercept through that flank; NaN where none could be drawn";
  const Columns<std::vector<SurfaceBin>> bins{
      column("x", &SurfaceBin::x, "L", "centre of the bin"),
      column("height", &SurfaceBin::height, "L", "highest grain top in the bin above the base centres"),
      column("used", &SurfaceBin::used, "", "1: used for the line of its flank"),
  };
  to.groups.push_back(
      analysis_group({"surface",
                      "bins",
                      {
                          attribute<Measured>(
                              "bin_width", [](const Measured& run) { return run.record.scene.analysis.bin_width; }, "L",
                              "`analysis.bin_width`"),
                          attribute<Measured>(
                              "base_y", [](const Measured& run) { return run.results.base_height; }, "L",
                              "height of the base centres, from which heights count"),
                          attribute<Measured>("apex_x", heap(&HeapShape::apex_x), "L", "of the highest bin"),
                          attribute<Measured>("apex_height", heap(&HeapShape::apex_height), "L", "of the highest bin"),
                          of_flank("left_slope", &HeapShape::left, &FlankLine::slope, "", line),
                          of_flank("left_intercept", &HeapShape::left, &FlankLine::intercept, "L", line),
                          of_flank("right_slope", &HeapShape::right, &FlankLine::slope, "", line),
                          of_flank("right_intercept", &HeapShape::right, &FlankLine::intercept, "L", line),
                      },
                      columns_of<Measured>(
                          bins, [](const Measured& run) -> const auto& { return run.results.heap.surface; })},
                     [](const Measured& run) { return has(run.record.scene, Needs::forces); }));
}

void add_voronoi(Registry& to) {
  using Cells = std::vector<VoronoiCell>;
  const auto offsets = [](const Cells& cells) {
    std::vector<std::int64_t> all{0};
    for (const auto& cell : cells) all.push_back(all.back() + static_cast<std::int64_t>(cell.vertices.size()));
    return all;
  };
  const auto vertices = [](const Cells& cells) {
    std::vector<Vec<2>> all;
    for (const auto& cell : cells) all.insert(all.end(), cell.vertices.begin(), cell.vertices.end());
    return all;
  };
  const Group<Cells> group{
      "voronoi",
      "G",
      {},
      {
          column("id", &VoronoiCell::id, "", "grain, ascending"),
          column("area", &VoronoiCell::area, "L^2", "of its cell"),
          column("solid_fraction", &VoronoiCell::solid_fraction, "", "area of the disc over that of its cell"),
          column("closed", &VoronoiCell::closed, "",
                 "1: ends at neighbours or walls on all sides; 0: at the cut-off, as at a free surface"),
          with_rows("G + 1",
                    array<Cells>("offset", offsets, "", "vertices of cell k are rows offset[k] to offset[k + 1]")),
          with_rows("V", array<Cells>("vertices", vertices, "L", "counter-clockwise")),
      }};
  to.groups.push_back(analysis_group(
      group, [](const Measured& run) { return run.results.cells.empty() ? nullptr : &run.results.cells; }));
}

}  // namespace

/// Shape of the heap and its inside.
void add_heap(Registry& to) {
  const auto core = [](auto member) { return [=](const Measured& run) { return run.results.core.*member; }; };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("angle_of_repose_deg", "",
              "of the surface profile, which is defined below; null where walls steeper than 45 deg bear a hundredth "
              "of the weight",
              [](const Measured&) { return Object{}; }));
  add(measure("angle_of_repose_deg.left", "deg", "of the line through the left flank", angle_of(&HeapShape::left)));
  add(measure("angle_of_repose_deg.right", "deg", "of the line through the right flank", angle_of(&HeapShape::right)));
  add(measure("angle_of_repose_deg.mean", "deg", "mean of left and right", mean_angle));
  add(measure("angle_of_repose_deg.moments", "deg",
              "atan(<y>/<abs(x - <x>)>); null unless the surface falls below half of its height at both ends",
              [](const Measured& run) { return run.results.heap.moments_angle_deg; }));
  add(measure("heap_height", "L", "highest grain top above the base centres",
              [](const Measured& run) -> std::optional<double> {
                if (run.results.heap.surface.empty()) return std::nullopt;
                return run.results.heap.apex_height;
              }));
  add(measure(
      "core", "", "inside of the heap, `analysis.core_depth` below the surface and 2 diameters above the base centres",
      [](const Measured& run) { return run.results.core.grains > 0 ? std::optional(Object{}) : std::nullopt; }));
  add(measure("core.grains", "", "grains in it", core(&CoreRegion::grains)));
  add(measure("core.solid_fraction", "", "disc area over area of the Voronoi cells",
              core(&CoreRegion::solid_fraction)));
  add(measure("core.coordination", "", "mean number of contacts that count", core(&CoreRegion::coordination)));
  add_surface(to);
  add_voronoi(to);
}

}  // namespace repose
