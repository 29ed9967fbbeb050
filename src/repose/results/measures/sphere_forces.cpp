// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

using Run = MeasuredIn<3>;

double mean_normal(const Run& run) { return run.results.forces->mean / run.record.scene.base_force_unit(); }

void add_distribution(RegistryIn<3>& to) {
  const Group<ForceStatistics> group{
      "forces",
      "bins",
      {attribute("mean", &ForceStatistics::mean, "M L/T^2", "normal force of the contacts that count"),
       attribute("bin_width", &ForceStatistics::bin_width, "", "of f")},
      {
          array("f", &ForceStatistics::f, "",
                "normal force over its mean, centre of the bin; bins begin at the force threshold"),
          array("density", &ForceStatistics::density, "", "probability density P(f); its integral over all bins is 1"),
          array("error", &ForceStatistics::error, "", "of the density, from the square root of the count"),
          with_rows("20", array("direction_cosine", &ForceStatistics::direction_cosine, "",
                                "of the angle between a contact and the vertical, centre of the bin")),
          with_rows("20", array("direction_all", &ForceStatistics::direction_all, "",
                                "probability density of all contacts that count; 1 if directions are isotropic")),
          with_rows("20", array("direction_strong", &ForceStatistics::direction_strong, "",
                                "probability density of contacts above the mean force")),
      }};
  to.groups.push_back(analysis_group<ForceStatistics, 3>(
      group, [](const Run& run) { return run.results.forces ? &*run.results.forces : nullptr; }));
}

/// An axis, which has no sign, as the vector that does not point down.
std::array<double, 3> upwards(const Vec<3>& axis) {
  const double sign = axis[up<3>] < 0.0 ? -1.0 : 1.0;
  return {sign * axis[0], sign * axis[1], sign * axis[2]};
}

void add_fabric(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  add(measure<3>("fabric", "", "of the contacts that count, without those of walls",
                 [](const Run& run) { return run.results.fabric ? std::optional(Object{}) : std::nullopt; }));
  const auto add_part = [&](const std::string& prefix, const std::string& meaning, const auto& part) {
    const auto of = [=](auto entry) {
      return [=](const Run& run) -> std::optional<double> {
        const SpaceFabric* found = part(*run.results.fabric);
        return found != nullptr ? std::optional<double>(entry(*found)) : std::nullopt;
      };
    };
    add(measure<3>(prefix + "deviator", "", "deviator of <n n> of " + meaning + ": 0 isotropic, 1 all parallel",
                   of([](const SpaceFabric& fabric) { return fabric.deviator; })));
    add(measure<3>(prefix + "inclination_deg", "deg", "of the major axis above the horizontal",
                   of([](const SpaceFabric& fabric) { return fabric.inclination_deg; })));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = std::to_string(k + 1);
      add(measure<3>(prefix + "eigenvalue_" + number, "", "in descending order; their sum is 1",
                     of([=](const SpaceFabric& fabric) { return fabric.principal.value[k]; })));
      add(measure<3>(prefix + "axis_" + number, "", "list: x, y and z of its eigenvector, of length 1, not downwards",
                     [=](const Run& run) -> std::optional<std::array<double, 3>> {
                       const SpaceFabric* found = part(*run.results.fabric);
                       if (found == nullptr) return std::nullopt;
                       return upwards(found->principal.axis[k]);
                     }));
    }
  };
  add_part("fabric.", "all", [](const ContactFabric& fabric) { return &fabric.all; });
  add_part("fabric.strong_", "contacts above the mean force",
           [](const ContactFabric& fabric) { return fabric.strong ? &*fabric.strong : nullptr; });
}

}  // namespace

/// Contacts that count, their forces, directions and chains.
void add_sphere_forces(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  const auto network = [](auto member) { return [=](const Run& run) { return run.results.network.*member; }; };
  add(measure<3>("coordination", "", "mean number of contacts that count of a grain that touches something",
                 network(&NetworkOfForces<3>::coordination)));
  add(measure<3>("anisotropy", "", "deviator of the fabric tensor <n n> of those contacts, with those of walls",
                 network(&NetworkOfForces<3>::anisotropy)));
  add(measure<3>("connectivity", "", "list: fraction of those grains with 0, 1, ... 11, and 12 or more such contacts",
                 [](const Run& run) -> std::optional<std::array<double, most_contacts<3> + 1>> {
                   if (!run.results.network.coordination) return std::nullopt;
                   return run.results.network.connectivity;
                 }));
  add(measure<3>("forces", "", "normal forces of the contacts that count and push",
                 [](const Run& run) { return run.results.forces ? std::optional(Object{}) : std::nullopt; }));
  add(measure<3>("forces.mean", "grain weights", "mean; in M L/T^2 without gravity", mean_normal));
  add(measure<3>("forces.strong_fraction", "", "fraction of contacts above the mean",
                 [](const Run& run) { return run.results.forces->strong_fraction; }));
  add(measure<3>("forces.sliding_fraction", "", "fraction of contacts at the Coulomb limit",
                 [](const Run& run) { return run.results.forces->sliding_fraction; }));
  add(measure<3>("chains", "", "force chains: connected contacts above the mean force", [](const Run& run) {
    return run.results.chains.list.empty() ? std::nullopt : std::optional(Object{});
  }));
  add(measure<3>("chains.count", "", "number of chains",
                 [](const Run& run) { return run.results.chains.list.size(); }));
  add(measure<3>("chains.largest_contacts", "", "of the largest chain",
                 [](const Run& run) { return run.results.chains.list.front().contacts; }));
  add(measure<3>("chains.largest_height", "L", "of the largest chain",
                 [](const Run& run) { return run.results.chains.list.front().height; }));
  add_fabric(to);
  add_distribution(to);
}

}  // namespace repose
