// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <cmath>

namespace repose {

// Each is defined in a file of results/measures.
void add_sphere_base(RegistryIn<3>& to);
void add_sphere_fields(RegistryIn<3>& to);
void add_sphere_forces(RegistryIn<3>& to);
void add_sphere_packing(RegistryIn<3>& to);

namespace {

using Run = MeasuredIn<3>;

void add_cone_groups(RegistryIn<3>& to) {
  const auto line = [](double FlankLine::*member) {
    return [=](const ConicalHeap& cone) { return cone.line ? (*cone.line).*member : std::nan(""); };
  };
  const Columns<std::vector<ConeRing>> rings{
      column("r", &ConeRing::radius, "L", "from the axis to the middle of the ring"),
      column("height", &ConeRing::height, "L", "of the surface above the base centres, mean over the azimuth"),
      column("sector_height", &ConeRing::sector_height, "L", "mean over each of eight sectors; NaN without a grain"),
      column("used", &ConeRing::used, "", "1: used for the line"),
  };
  const Group<ConicalHeap> surface{
      "cone_surface",
      "rings",
      {
          attribute<ConicalHeap>(
              "axis_x", [](const ConicalHeap& cone) { return cone.axis[0]; }, "L",
              "of the axis, by the centre of mass"),
          attribute<ConicalHeap>(
              "axis_y", [](const ConicalHeap& cone) { return cone.axis[1]; }, "L", "of the axis"),
          attribute("apex_height", &ConicalHeap::apex_height, "L", "highest grain top above the base centres"),
          attribute<ConicalHeap>("slope", line(&FlankLine::slope), "", "of the line h = slope r + intercept"),
          attribute<ConicalHeap>("intercept", line(&FlankLine::intercept), "L", "of that line"),
          attribute<ConicalHeap>("angle_deg", line(&FlankLine::angle_deg), "deg", "of that line below the horizontal"),
      },
      columns_of<ConicalHeap>(rings, &ConicalHeap::surface)};
  to.groups.push_back(analysis_group<ConicalHeap, 3>(
      surface, [](const Run& run) { return run.results.cone.surface.empty() ? nullptr : &run.results.cone; }));
  const auto azimuths = [](const ConicalHeap& cone) {
    std::vector<double> middles;
    const auto count = static_cast<double>(cone.sector_lines.size());
    for (double k = 0.5; k < count; k += 1.0) middles.push_back(360.0 * k / count);
    return middles;
  };
  const auto angles = [](const ConicalHeap& cone) {
    std::vector<double> all;
    for (const auto& one : cone.sector_lines) all.push_back(one ? one->angle_deg : std::nan(""));
    return all;
  };
  const Group<ConicalHeap> sectors{"cone_sectors",
                                   "8",
                                   {},
                                   {array<ConicalHeap>("azimuth_deg", azimuths, "deg", "of the middle, from x to y"),
                                    array<ConicalHeap>("angle_deg", angles, "deg", "of the line through its surface")}};
  to.groups.push_back(analysis_group<ConicalHeap, 3>(
      sectors, [](const Run& run) { return run.results.cone.surface.empty() ? nullptr : &run.results.cone; }));
}

}  // namespace

/// What is measured of spheres: the cone and its inside, and what the other files add.
void add_spheres(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  const auto core = [](auto member) { return [=](const Run& run) { return run.results.core.*member; }; };
  add(measure<3>(
      "angle_of_repose_deg", "",
      "of a conical heap; null unless the surface falls below half of its height on all sides, and where walls steeper "
      "than 45 deg bear a hundredth of the weight",
      [](const Run&) { return Object{}; }));
  add(measure<3>("angle_of_repose_deg.mean", "deg", "of the line through the surface averaged over the azimuth",
                 [](const Run& run) -> std::optional<double> {
                   if (!run.results.cone.line) return std::nullopt;
                   return run.results.cone.line->angle_deg;
                 }));
  add(measure<3>("angle_of_repose_deg.sectors", "deg", "mean over eight sectors",
                 [](const Run& run) { return run.results.cone.angle_deg.mean; }));
  add(measure<3>("angle_of_repose_deg.sectors_error", "deg", "standard error from the scatter of the sectors",
                 [](const Run& run) { return run.results.cone.angle_deg.error; }));
  add(measure<3>("angle_of_repose_deg.moments", "deg", "atan(2 <z>/<r>), exact for a uniform cone",
                 [](const Run& run) { return run.results.cone.moments_angle_deg; }));
  add(measure<3>("heap_height", "L", "highest grain top above the base centres",
                 [](const Run& run) -> std::optional<double> {
                   if (run.results.cone.surface.empty()) return std::nullopt;
                   return run.results.cone.apex_height;
                 }));
  add(measure<3>("core", "",
                 "inside of the heap, `analysis.core_depth` below the surface and 2 diameters above the base centres",
                 [](const Run& run) { return run.results.core.grains > 0 ? std::optional(Object{}) : std::nullopt; }));
  add(measure<3>("core.grains", "", "grains in it", core(&ConeCore::grains)));
  add(measure<3>("core.solid_fraction", "", "volume of the spheres over that of their Voronoi cells",
                 core(&ConeCore::solid_fraction)));
  add(measure<3>("core.coordination", "", "mean number of contacts that count", core(&ConeCore::coordination)));
  add_cone_groups(to);
  add_sphere_forces(to);
  add_sphere_base(to);
  add_sphere_fields(to);
  add_sphere_packing(to);
}

}  // namespace repose
