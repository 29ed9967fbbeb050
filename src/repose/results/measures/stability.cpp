// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// The smallest eigenvalue of the stiffness matrix: only where the analysis was asked for it.
void add_stability(Registry& to) {
  const auto asked = [](const Measured& run) { return run.results.stability.has_value(); };
  const auto of = [](auto member) {
    return [=](const Measured& run) { return std::invoke(member, *run.results.stability); };
  };
  const auto count = [](auto member) {
    return [=](const Measured& run) -> std::optional<std::int64_t> {
      const auto& found = *run.results.stability;
      if (!found.problem.empty()) return std::nullopt;
      return std::invoke(member, found);
    };
  };
  const auto add = [&](Measure measure) { to.measures.push_back(std::move(measure)); };
  add(only_where(asked, measure("stability", "", "smallest eigenvalue of the stiffness matrix (`--stability`)",
                                [](const Measured&) { return Object{}; })));
  add(measure("stability.problem", "", "why there is no matrix; empty where there is one", of(&Stability::problem)));
  add(measure("stability.grains", "", "moving grains with a contact that carries force", count(&Stability::grains)));
  add(measure("stability.contacts", "", "contacts that carry force on these grains", count(&Stability::contacts)));
  add(measure("stability.directions", "", "degrees of freedom of these grains: the size of the matrix",
              count(&Stability::directions)));
  add(measure("stability.unbalanced", "grain weights", "largest net force on one of these grains, as recorded",
              of(&Stability::unbalanced)));
  add(measure("stability.stiffness", "grain weights / d", "mean stiffness of these contacts; in M/T^2 without gravity",
              of(&Stability::stiffness)));
  add(measure("stability.smallest", "grain weights / d",
              "smallest eigenvalue; below 0: unstable; in M/T^2 without gravity", of(&Stability::smallest)));
  add(measure("stability.relative", "", "smallest eigenvalue over the mean stiffness", of(&Stability::relative)));
  add(measure("stability.negative", "", "eigenvalues below -1e-9 of the mean stiffness", count(&Stability::negative)));
  add(measure("stability.neutral", "", "eigenvalues within 1e-9 of the mean stiffness of 0",
              count(&Stability::neutral)));
  add(measure("stability.residual", "", "norm of K u - smallest u over that of u and the mean stiffness",
              of(&Stability::residual)));
  add(measure("stability.participation", "",
              "number of grains that take part in the mode: (sum of u^2)^2 over the sum of u^4",
              of(&Stability::participation)));
  using Rows = std::vector<GrainMode>;
  Columns<Rows> columns{
      column("id", &GrainMode::id, "", "moving grain with a contact that carries force, ascending"),
      column("displacement", &GrainMode::displacement, "",
             "of the grain in the mode of the smallest eigenvalue, over the largest of all grains"),
  };
  Group<Stability> group{"stability",
                         "grains",
                         {attribute("smallest", &Stability::smallest, "grain weights / d", "`stability.smallest`")},
                         columns_of<Stability>(columns, &Stability::mode)};
  to.groups.push_back(analysis_group(group, [](const Measured& run) {
    const auto& found = run.results.stability;
    return found && !found->mode.empty() ? &*found : nullptr;
  }));
}

}  // namespace repose
