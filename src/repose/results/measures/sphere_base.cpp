// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

using Run = MeasuredIn<3>;

void add_wall_forces(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  const auto component = [](int axis) {
    return [=](const Run& run) {
      std::vector<double> values;
      for (const auto& wall : run.results.walls.walls) values.push_back(wall.force[axis]);
      return values;
    };
  };
  add(measure<3>("walls", "", "lists: force of the grains on each wall that the scene has", [](const Run& run) {
    return run.results.walls.walls.empty() ? std::nullopt : std::optional(Object{});
  }));
  add(measure<3>("walls.name", "", "of the walls, in the order of the lists", [](const Run& run) {
    std::vector<std::string> names;
    for (const auto& wall : run.results.walls.walls) names.push_back(wall.name);
    return names;
  }));
  add(measure<3>("walls.force_x", "M L/T^2", "mean over the window", component(0)));
  add(measure<3>("walls.force_y", "M L/T^2", "mean over the window", component(1)));
  add(measure<3>("walls.force_z", "M L/T^2", "mean over the window", component(2)));
  add(measure<3>("walls.window", "T",
                 "start and end of the average, the last rows of the series that cover output.window",
                 [](const Run& run) {
                   return std::vector<double>{run.results.walls.window_start, run.results.walls.window_end};
                 }));
}

void add_base_cells(RegistryIn<3>& to) {
  const Columns<std::vector<BaseCell>> cells{
      column("x", &BaseCell::x, "L", "middle of the cell"),
      column("y", &BaseCell::y, "L", "the same along y"),
      column("count", &BaseCell::count, "", "base grains in it, or contacts with the floor"),
      column("pressure", &BaseCell::pressure, "M/(L T^2)",
             "normal force over the area of the cell, positive downwards"),
      column("shear_x", &BaseCell::shear_x, "M/(L T^2)", "force on the base along x over that area"),
      column("shear_y", &BaseCell::shear_y, "M/(L T^2)", "along y"),
  };
  const Group<BaseCells> group{
      "base_cells",
      "cells",
      {attribute<BaseCells>(
           "side_x", [](const BaseCells& base) { return base.side[0]; }, "L", "of a cell along x"),
       attribute<BaseCells>(
           "side_y", [](const BaseCells& base) { return base.side[1]; }, "L", "of a cell along y"),
       attribute("load", &BaseCells::load, "M L/T^2", "sum of all normal forces: of pressure times area"),
       attribute<BaseCells>(
           "traction_x", [](const BaseCells& base) { return base.traction[0]; }, "M L/T^2",
           "sum of all shear forces along x"),
       attribute<BaseCells>(
           "traction_y", [](const BaseCells& base) { return base.traction[1]; }, "M L/T^2", "along y")},
      columns_of<BaseCells>(cells, &BaseCells::cells)};
  to.groups.push_back(analysis_group<BaseCells, 3>(
      group, [](const Run& run) { return run.results.base_cells.cells.empty() ? nullptr : &run.results.base_cells; }));
}

}  // namespace

/// The pressure on the base by rings and cells, the forces on walls, and how well they balance the weight.
void add_sphere_base(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  add(measure<3>("base_dip", "", "whether the pressure dips under the apex",
                 [](const Run& run) { return run.results.base.dip_index ? std::optional(Object{}) : std::nullopt; }));
  add(measure<3>("base_dip.index", "", "mean pressure over 0.15-0.45 of the loaded radius over the mean within 0.15",
                 [](const Run& run) { return run.results.base.dip_index->mean; }));
  add(measure<3>("base_dip.index_error", "", "its jackknife error over eight sectors",
                 [](const Run& run) { return run.results.base.dip_index->error; }));
  add(measure<3>("base_dip.loaded_radius", "L", "that holds 97.2 % of the load, as 0.9 radii of a full cone do",
                 [](const Run& run) { return run.results.base.loaded_radius; }));
  add(measure<3>(
      "weight_error", "",
      "vertical force on fixed grains and walls over the weight of the grains that touch something, less 1",
      [](const Run& run) { return run.results.weight_error; }, Needs::forces));
  add_wall_forces(to);
  const Columns<std::vector<BaseRing>> rings{
      column<BaseRing>(
          "r", [](const BaseRing& ring) { return 0.5 * (ring.inner + ring.outer); }, "L", "middle of the ring"),
      column("inner", &BaseRing::inner, "L", "inner radius"),
      column("outer", &BaseRing::outer, "L", "outer radius"),
      column<BaseRing>(
          "count", [](const BaseRing& ring) { return static_cast<std::int64_t>(ring.count); }, "",
          "base grains in it, or contacts with the floor"),
      column("area", &BaseRing::area, "L^2", "of it"),
      column("pressure", &BaseRing::pressure, "M/(L T^2)", "normal force per area, positive downwards"),
      column("pressure_error", &BaseRing::pressure_error, "M/(L T^2)", "jackknife over eight sectors"),
      column("shear", &BaseRing::shear, "M/(L T^2)", "radial force per area, positive outwards"),
      column("shear_error", &BaseRing::shear_error, "M/(L T^2)", "jackknife over eight sectors"),
      column("load", &BaseRing::cumulative, "M L/T^2", "normal force within the outer radius"),
  };
  const Group<BaseRings> group{"base_rings",
                               "rings",
                               {attribute("load", &BaseRings::load, "M L/T^2", "sum of all normal forces")},
                               columns_of<BaseRings>(rings, &BaseRings::rings)};
  to.groups.push_back(analysis_group<BaseRings, 3>(
      group, [](const Run& run) { return run.results.base.rings.empty() ? nullptr : &run.results.base; }));
  add_base_cells(to);
}

}  // namespace repose
