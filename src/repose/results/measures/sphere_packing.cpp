// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

namespace {

using Run = MeasuredIn<3>;

void add_cells(RegistryIn<3>& to) {
  using Cells = std::vector<SphereCell>;
  const Group<Cells> group{
      "voronoi",
      "G",
      {},
      {
          column("id", &SphereCell::id, "", "grain, ascending"),
          column("volume", &SphereCell::volume, "L^3", "of its cell"),
          column("solid_fraction", &SphereCell::solid_fraction, "", "volume of the sphere over that of its cell"),
          column("closed", &SphereCell::closed, "",
                 "1: ends at neighbours or walls on all sides; 0: at the cut-off, as at a free surface"),
      }};
  to.groups.push_back(analysis_group<Cells, 3>(
      group, [](const Run& run) { return run.results.cells.empty() ? nullptr : &run.results.cells; }));
}

void add_structure(RegistryIn<3>& to) {
  const Group<Correlation> correlation{
      "pair_correlation",
      "bins",
      {},
      {array("r", &Correlation::distance, "L", "centres of the bins"),
       array("g", &Correlation::value, "", "pairs over the number expected for independent points"),
       array("error", &Correlation::error, "", "from the square root of the count")}};
  to.groups.push_back(analysis_group<Correlation, 3>(correlation, [](const Run& run) {
    return run.results.pair_correlation ? &*run.results.pair_correlation : nullptr;
  }));
  const Group<IsotropicStructureFactor> factor{
      "structure_factor",
      "shells",
      {},
      {array("q", &IsotropicStructureFactor::wave_number, "1/L", "mean wave number of the shell"),
       array("s", &IsotropicStructureFactor::value, "", "mean of S over its wave vectors"),
       array("error", &IsotropicStructureFactor::error, "", "standard error of the mean")}};
  to.groups.push_back(analysis_group<IsotropicStructureFactor, 3>(
      factor, [](const Run& run) { return run.results.structure_factor ? &*run.results.structure_factor : nullptr; }));
}

}  // namespace

/// The packing in a slab.
void add_sphere_packing(RegistryIn<3>& to) {
  const auto add = [&](MeasureIn<3> measure) { to.measures.push_back(std::move(measure)); };
  const auto of = [](auto member) { return [=](const Run& run) { return (*run.results.packing).*member; }; };
  const auto edge = [](double PackingCore::*member) {
    return [=](const Run& run) { return (*run.results.slab).*member; };
  };
  add(measure<3>("packing", "", "in a slab between two levels, where `analysis.packing` asks for it",
                 [](const Run& run) { return run.results.packing ? std::optional(Object{}) : std::nullopt; }));
  add(measure<3>("packing.low", "L", "lower level of the slab", edge(&PackingCore::low)));
  add(measure<3>("packing.high", "L", "upper level of the slab", edge(&PackingCore::high)));
  add(measure<3>("packing.spheres", "", "with their centre in it", of(&SpherePacking::spheres)));
  add(measure<3>("packing.solid_fraction", "", "volume of the spheres with closed Voronoi cells over that of the cells",
                 of(&SpherePacking::solid_fraction)));
  add(measure<3>("packing.coordination", "", "mean number of neighbours that touch, walls too",
                 of(&SpherePacking::coordination)));
  add(measure<3>("packing.rattlers", "", "fraction with fewer than three such neighbours that are no rattlers",
                 of(&SpherePacking::rattlers)));
  add(measure<3>("packing.without_rattlers", "", "coordination of the others among each other",
                 of(&SpherePacking::without_rattlers)));
  add_cells(to);
  add_structure(to);
}

}  // namespace repose
