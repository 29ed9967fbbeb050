// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

double part(std::size_t some, std::size_t all) { return static_cast<double>(some) / static_cast<double>(all); }

}  // namespace

/// The strongest and the weakest contact of each grain, and the contacts along rows.
void add_force_lines(Registry& to) {
  const auto of = [](auto entry) {
    return [=](const Measured& run) { return std::invoke(entry, run.results.force_lines); };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("force_lines", "", "lines of force, through the strongest and the weakest contact of each grain",
              [](const Measured& run) {
                return run.results.force_lines.grains.empty() ? std::nullopt : std::optional(Object{});
              }));
  add(measure("force_lines.grains", "", "moving grains with a contact that counts",
              of([](const ForceLines& lines) { return lines.grains.size(); })));
  add(measure("force_lines.horizontal", "",
              "contacts between two grains that count and are within 15 deg of the horizontal",
              of(&ForceLines::horizontal)));
  add(measure("force_lines.horizontal_fraction", "", "of the contacts between two grains that count",
              of([](const ForceLines& lines) { return part(lines.horizontal, lines.contacts); })));
  add(measure("force_lines.largest_horizontal", "grain weights",
              "largest normal force of a horizontal contact, 0 without any; in M L/T^2 without gravity",
              [](const Measured& run) {
                return run.results.force_lines.largest_horizontal / run.record.scene.base_force_unit();
              }));
  add(measure("force_lines.strongest_horizontal", "", "fraction of those grains whose strongest contact is horizontal",
              of([](const ForceLines& lines) { return part(lines.strongest_horizontal, lines.grains.size()); })));
  add(measure("force_lines.weakest_horizontal", "", "fraction of those grains whose weakest contact is horizontal",
              of([](const ForceLines& lines) { return part(lines.weakest_horizontal, lines.grains.size()); })));
  using Rows = std::vector<ForceLine>;
  Columns<Rows> columns{
      column("id", &ForceLine::id, "", "moving grain with a contact that counts, ascending"),
      column("strongest", &ForceLine::strongest, "", "row of its strongest contact in `run.h5:/contacts`"),
      column("weakest", &ForceLine::weakest, "", "row of its weakest contact that counts"),
      column("strongest_force", &ForceLine::strongest_force, "M L/T^2", "normal force of the strongest contact"),
      column("weakest_force", &ForceLine::weakest_force, "M L/T^2", "normal force of the weakest contact"),
  };
  Group<ForceLines> group{"force_lines",
                          "grains",
                          {attribute<ForceLines>(
                              "horizontal_within", [](const ForceLines&) { return horizontal_within; }, "deg",
                              "of the horizontal lies the normal of a horizontal contact")},
                          columns_of<ForceLines>(columns, &ForceLines::grains)};
  to.groups.push_back(analysis_group(group, [](const Measured& run) {
    return run.results.force_lines.grains.empty() ? nullptr : &run.results.force_lines;
  }));
}

}  // namespace repose
