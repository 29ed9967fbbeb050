// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// Which base forces equilibrium allows: only where the analysis was asked for it.
void add_force_range(Registry& to) {
  const auto asked = [](const Measured& run) { return run.results.force_range.has_value(); };
  const auto of = [](auto member) {
    return [=](const Measured& run) { return std::invoke(member, *run.results.force_range); };
  };
  const auto count = [](auto member) {
    return [=](const Measured& run) -> std::optional<std::int64_t> {
      const auto& range = *run.results.force_range;
      if (range.contacts == 0) return std::nullopt;
      return std::invoke(member, range);
    };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(only_where(asked, measure("force_range", "", "base forces that equilibrium allows (`--force-range`)",
                                [](const Measured&) { return Object{}; })));
  add(measure("force_range.problem", "", "why there is no range; empty where there is one", of(&ForceRange::problem)));
  add(measure("force_range.contact_gap", "mean diameters",
              "closer grains touch: `analysis.contact_gap`, or its default where no packing is measured",
              of(&ForceRange::contact_gap)));
  add(measure("force_range.contacts", "", "contacts that touch, or carry force", count(&ForceRange::contacts)));
  add(measure("force_range.unknowns", "", "normal, frictional and rolling forces of these contacts",
              count(&ForceRange::unknowns)));
  add(measure("force_range.equations", "", "balances of force and torque of the grains",
              count(&ForceRange::equations)));
  add(measure("force_range.degree", "", "unknowns less equations", count(&ForceRange::degree)));
  add(measure("force_range.unbalanced", "grain weights",
              "largest net force on a grain, or torque over its radius, of the recorded forces",
              of(&ForceRange::unbalanced)));
  add(measure("force_range.cold_residual", "g dt", "of the cold solution", of(&ForceRange::cold_residual)));
  const auto add_range = [&](const std::string& name, AllowedRange ForceRange::*range, const std::string& unit,
                             const std::string& meaning) {
    const auto value = [=](double AllowedRange::*member) {
      return [=](const Measured& run) { return (*run.results.force_range).*range.*member; };
    };
    const auto key = "force_range." + name;
    add(measure(key, "", meaning, [](const Measured&) { return Object{}; }));
    add(measure(key + ".min", unit, "over all states of equilibrium", value(&AllowedRange::least)));
    add(measure(key + ".max", unit, "over all states of equilibrium; null: no bound", value(&AllowedRange::most)));
    add(measure(key + ".cold", unit, "of the contact problem of the state solved from zero impulses",
                value(&AllowedRange::cold)));
    add(measure(key + ".warm", unit, "of the recorded forces", value(&AllowedRange::warm)));
  };
  add_range("central_force", &ForceRange::central_force, "grain weights",
            "mean normal force on base grains within 0.15 of the half-width of `base_dip`");
  add_range("dip", &ForceRange::dip, "", "dip index, with centre and half-width of `base_dip`");
  add_range("largest", &ForceRange::largest, "grain weights", "largest normal force on a base grain");
  add_range("load_ratio", &ForceRange::load_ratio, "",
            "load of the floor of a column between two upright walls over its weight, as `column.load_ratio`");
  add_range("wall_ratio", &ForceRange::wall_ratio, "", "normal force on its two walls, summed, over its weight");
  to.groups.push_back(analysis_group<BinnedRange>(
      {"force_range",
       "bins",
       {attribute("bin_width", &BinnedRange::bin_width, "L", "`analysis.base_bin`")},
       {
           array("x", &BinnedRange::x, "L", "centre of the bin"),
           array("min", &BinnedRange::least, "grain weights", "least mean normal force that equilibrium allows"),
           array("max", &BinnedRange::most, "grain weights", "largest; NaN: no bound"),
       }},
      [](const Measured& run) {
        const auto& found = run.results.force_range;
        return found && !found->base.x.empty() ? &found->base : nullptr;
      }));
}

}  // namespace repose
