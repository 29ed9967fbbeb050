// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// Forces of the grains on walls.
void add_walls(Registry& to) {
  const auto list = [](auto member) {
    return [=](const Measured& run) {
      std::vector<std::remove_cvref_t<decltype(std::declval<WallForce>().*member)>> values;
      for (const auto& wall : run.results.walls.walls) values.push_back(wall.*member);
      return values;
    };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("walls", "", "lists: force of the grains on each wall that the scene has", [](const Measured& run) {
    return run.results.walls.walls.empty() ? std::nullopt : std::optional(Object{});
  }));
  add(measure("walls.name", "", "of the walls, in the order of the lists", list(&WallForce::name)));
  add(measure("walls.length", "L", "of the part that grains can press on, at the end", list(&WallForce::length)));
  add(measure("walls.pressure", "M/T^2", "normal force per length, positive into the wall; null without a length",
              list(&WallForce::pressure)));
  add(measure("walls.shear", "M/T^2", "force per length along the normal turned by +90 degrees",
              list(&WallForce::shear)));
  add(measure("walls.moment", "M L^2/T^2", "about the middle of that part, counter-clockwise",
              list(&WallForce::moment)));
  add(measure("walls.window", "T", "start and end of the average, the last rows of the series that cover output.window",
              [](const Measured& run) {
                return std::vector<double>{run.results.walls.window_start, run.results.walls.window_end};
              }));
  using Rows = std::vector<WallForce>;
  const Columns<Rows> columns{
      column("name", &WallForce::name, "", "\"base\", or that of the scene"),
      column("length", &WallForce::length, "L",
             "of a finite wall; of a plane the part between other planes, and else as far as moving grains reach"),
      column("middle", &WallForce::middle, "L", "of that part at the end"),
      column("force", &WallForce::force, "M L/T^2", "of the grains on the wall"),
      column("pressure", &WallForce::pressure, "M/T^2", "minus force times normal, over the length; NaN without one"),
      column("shear", &WallForce::shear, "M/T^2", "force along the normal turned by +90 degrees, over the length"),
      column("moment", &WallForce::moment, "M L^2/T^2",
             "about the middle, counter-clockwise; mean over the contacts at the rows of the series"),
  };
  to.groups.push_back(analysis_group<WallForces>(
      {"walls",
       "W",
       {
           attribute("window_start", &WallForces::window_start, "T", "means are from then"),
           attribute("window_end", &WallForces::window_end, "T", "until then"),
       },
       columns_of<WallForces>(
           columns, [](const WallForces& forces) -> const auto& { return forces.walls; })},
      [](const Measured& run) { return run.results.walls.walls.empty() ? nullptr : &run.results.walls; }));
}

}  // namespace repose
