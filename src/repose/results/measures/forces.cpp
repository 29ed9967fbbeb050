// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

bool has_forces(const Measured& run) { return run.results.forces.has_value(); }

/// Mean normal force [grain weights, or M L/T^2 without gravity].
double mean_force(const Measured& run) { return run.results.forces->mean / run.record.scene.base_force_unit(); }

double mean_contacts(const Measured& run) {
  const auto& list = run.results.chains.list;
  double contacts = 0.0;
  for (const auto& chain : list) contacts += static_cast<double>(chain.contacts);
  return contacts / static_cast<double>(list.size());
}

void add_statistics(Registry& to) {
  const auto values = [](const std::string& name, auto member, const std::string& unit, const std::string& meaning) {
    return array<Measured>(
        name, [=](const Measured& run) -> const auto& { return (*run.results.forces).*member; }, unit, meaning);
  };
  to.groups.push_back(analysis_group(
      {"forces",
       "bins",
       {
           attribute<Measured>("mean", mean_force, "grain weights",
                               "normal force of the contacts that count; in M L/T^2 without gravity"),
           attribute<Measured>(
               "bin_width", [](const Measured& run) { return run.results.forces->bin_width; }, "", "of f"),
       },
       {
           values("f", &ForceStatistics::f, "",
                  "normal force over its mean, centre of the bin; bins begin at the force threshold"),
           values("density", &ForceStatistics::density, "",
                  "probability density P(f); its integral over all bins is 1"),
           values("error", &ForceStatistics::error, "", "of the density, from the square root of the count"),
           with_rows("36",
                     values("direction_deg", &ForceStatistics::direction_deg, "deg",
                            "of a contact from the horizontal, centre of the bin; the first is around 0 and 180")),
           with_rows("36", values("direction_all", &ForceStatistics::direction_all, "1/deg",
                                  "probability density of all contacts that count")),
           with_rows("36", values("direction_strong", &ForceStatistics::direction_strong, "1/deg",
                                  "probability density of contacts above the mean force")),
       }},
      has_forces));
}

void add_chain_list(Registry& to) {
  const Columns<std::vector<Chain>> list{
      column("contacts", &Chain::contacts, "", "contacts of the chain"),
      column("grains", &Chain::grains, "", "grains of the chain; base grains count once"),
      column("direction_deg", &Chain::direction_deg, "deg",
             "axis of the largest eigenvalue of <n n> over its contacts, in (-90, 90] from the horizontal"),
      column<Chain>(
          "extent", [](auto& chain) { return std::tie(chain.width, chain.height); }, "L",
          "width and height of the box around the centres of its grains"),
  };
  Group<Chains> group{"chains", "K", {}, columns_of<Chains>(list, &Chains::list)};
  group.columns.push_back(with_rows("M", array("chain", &Chains::chain_of_contact, "",
                                               "of each row of `run.h5:/contacts`; -1: not above the mean force")));
  to.groups.push_back(
      analysis_group(group, [](const Measured& run) { return has_forces(run) ? &run.results.chains : nullptr; }));
}

}  // namespace

/// Statistics of the forces, and force chains.
void add_forces(Registry& to) {
  const auto largest = [](auto member) {
    return [=](const Measured& run) { return run.results.chains.list.front().*member; };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(measure("forces", "", "normal forces of the contacts that count and push",
              [](const Measured& run) { return has_forces(run) ? std::optional(Object{}) : std::nullopt; }));
  add(measure("forces.mean", "grain weights", "mean; in M L/T^2 without gravity", mean_force));
  add(measure("forces.strong_fraction", "", "fraction of contacts above the mean",
              [](const Measured& run) { return run.results.forces->strong_fraction; }));
  add(measure("forces.sliding_fraction", "", "fraction of contacts at the Coulomb limit",
              [](const Measured& run) { return run.results.forces->sliding_fraction; }));
  add(measure("chains", "", "force chains: connected contacts above the mean force", [](const Measured& run) {
    return run.results.chains.list.empty() ? std::nullopt : std::optional(Object{});
  }));
  add(measure("chains.count", "", "number of chains",
              [](const Measured& run) { return run.results.chains.list.size(); }));
  add(measure("chains.mean_contacts", "", "of a chain", mean_contacts));
  add(measure("chains.largest_contacts", "", "of the largest chain", largest(&Chain::contacts)));
  add(measure("chains.largest_height", "L", "of the largest chain", largest(&Chain::height)));
  add_statistics(to);
  add_chain_list(to);
}

}  // namespace repose
