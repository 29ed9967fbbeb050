// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

#include <fmt/format.h>

namespace repose {

namespace {

bool is_measured(const Measured& run) { return run.results.packing.has_value(); }
bool has_surface(const Measured& run) { return is_measured(run) && run.results.packing->surface; }
bool has_local_density(const Measured& run) { return is_measured(run) && run.results.packing->local_density; }

/// Adds a key of `packing`, made from the Packing, where there is one.
template <class Entry>
void add(Registry& to, const std::string& name, const std::string& unit, const std::string& meaning, Entry entry,
         bool (*exists)(const Measured&) = is_measured) {
  to.measures.push_back(only_where(exists, measure("packing." + name, unit, meaning, [=](const Measured& run) {
                                     return std::invoke(entry, *run.results.packing);
                                   })));
}

using Tensor = FabricTensor Fabric::*;

void add_tensor(Registry& to, const std::string& name, const std::string& meaning, Tensor tensor) {
  add(to, name, "", meaning,
      [](const Packing& packing) { return packing.fabric ? std::optional(Object{}) : std::nullopt; });
  const auto of = [=](auto member) {
    return [=](const Packing& packing) { return ((*packing.fabric).*tensor).*member; };
  };
  add(to, name + ".xx", "", "<sin^2 theta>", of(&FabricTensor::xx));
  add(to, name + ".yy", "", "<cos^2 theta>", of(&FabricTensor::yy));
  add(to, name + ".xy", "", "<sin theta cos theta>", of(&FabricTensor::xy));
  add(to, name + ".anisotropy", "", "2 (l1 - l2)", of(&FabricTensor::anisotropy));
  add(to, name + ".direction_deg", "deg", "of the larger eigenvalue, from the vertical",
      of(&FabricTensor::direction_deg));
}

auto regime(std::optional<PackingRegime> Packing::*member) {
  return [=](const Packing& packing) -> std::optional<std::string> {
    const auto& found = packing.*member;
    if (!found) return std::nullopt;
    return std::string(name_of(*found));
  };
}

void add_slab(Registry& to) {
  const auto slab = [](auto member) { return [=](const Packing& packing) { return packing.slab.*member; }; };
  add(to, "slab", "", "in which the packing is measured", [](const Packing&) { return Object{}; });
  add(to, "slab.low", "L", "lower edge", slab(&Slab::low));
  add(to, "slab.high", "L", "upper edge", slab(&Slab::high));
  add(to, "slab.base_height", "L", "y of the base centres, 0 without base grains", slab(&Slab::base_height));
  add(to, "slab.mean_height", "L", "of the deposited centres above those of the base", slab(&Slab::mean_height));
}

void add_contacts(Registry& to) {
  const auto coordination = [](auto member) {
    return [=](const Packing& packing) { return packing.coordination.*member; };
  };
  add(to, "discs", "", "discs that are not of the base", &Packing::discs);
  add(to, "discs_in_slab", "", "discs with their centre in the slab", coordination(&Coordination::discs));
  add(to, "solid_fraction", "", "disc area in the slab over its area; errors of a packing are from 8 blocks along x",
      &Packing::solid_fraction);
  add(to, "coordination", "", "mean number of neighbours of a disc in the slab", coordination(&Coordination::mean));
  add(to, "coordination_without_rattlers", "", "without rattlers and contacts with them",
      coordination(&Coordination::without_rattlers));
  add(to, "rattlers", "", "fraction of discs with fewer than two contacts, left out again and again",
      coordination(&Coordination::rattlers));
  add(to, "connectivity_error", "", "list: errors of `P_0` to `P_6`", coordination(&Coordination::connectivity_error));
  for (std::size_t q = 0; q < std::tuple_size_v<decltype(Coordination::connectivity)>; ++q) {
    add(to, fmt::format("P_{}", q), "",
        fmt::format("fraction of discs in the slab whose number of contacts is {}",
                    q == 6 ? "6 or more" : std::to_string(q)),
        [=](const Packing& packing) { return packing.coordination.connectivity[q]; });
  }
}

void add_surface_of(Registry& to) {
  add(
      to, "roughness", "L", "rms height of the surface", [](const Packing& p) { return p.surface->roughness; },
      has_surface);
  add(
      to, "roughness_exponent", "", "alpha of width ~ window^alpha; null for fewer than three windows",
      [](const Packing& p) { return p.surface->scaling.exponent; }, has_surface);
  add(
      to, "growth_exponent", "", "beta of width ~ discs^beta; null for fewer than three numbers",
      [](const Packing& p) { return p.surface->growth.exponent; }, has_surface);
}

}  // namespace

/// A packing in its slab: where it is measured, `analysis.packing` decides.
void add_packing(Registry& to) {
  to.measures.push_back(measure(
      "packing", "", "where a packing is measured: a deposition, or `analysis.packing` (default in a periodic box)",
      [](const Measured& run) {
        const bool wanted = is_measured(run) || !run.results.packing_problem.empty();
        return wanted ? std::optional(Object{}) : std::nullopt;
      }));
  to.measures.push_back(
      only_where([](const Measured& run) { return !run.results.packing_problem.empty(); },
                 measure("packing.problem", "", "why it could not be measured; the other keys are left out then",
                         [](const Measured& run) { return run.results.packing_problem; })));
  add_slab(to);
  to.measures.push_back(
      only_where(is_measured, measure("packing.contact_gap", "mean diameters", "`analysis.contact_gap` of the scene",
                                      [](const Measured& run) { return run.record.scene.analysis.contact_gap; })));
  add_contacts(to);
  add_tensor(to, "fabric", "tensor of contact directions theta from the vertical", &Fabric::all);
  add_tensor(to, "fabric_folded", "the same of abs(theta)", &Fabric::folded);
  add(to, "regime", "", "by solid fraction (Bratberg 2003)", regime(&Packing::regime));
  add(to, "regime_by_structure", "", "by the most frequent number of contacts", regime(&Packing::regime_by_structure));
  add_surface_of(to);
  add(
      to, "local_density", "", "of Voronoi cells, with `analysis.local_density`",
      [](const Packing&) { return Object{}; }, has_local_density);
  add(
      to, "local_density.mean", "", "over closed cells", [](const Packing& p) { return p.local_density->density.mean; },
      has_local_density);
  add(
      to, "local_density.deviation", "", "standard deviation over closed cells",
      [](const Packing& p) { return p.local_density->density.deviation; }, has_local_density);
  to.measures.push_back(
      only_where([](const Measured& run) { return is_measured(run) && has(run.record.scene, Needs::deposition); },
                 measure(
                     "packing.discs_breaking_rule", "", "discs that do not rest by the critical-angle rule: must be 0",
                     [](const Measured& run) { return run.results.breaking_rule; }, Needs::deposition)));
}

}  // namespace repose
