// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// The stress of each grain.
void add_grain_stress(Registry& to) {
  using Rows = std::vector<GrainStress>;
  Columns<Rows> columns{
      column("id", &GrainStress::id, "", "grain, ascending; fixed ones too"),
      column("area", &GrainStress::area, "L^2", "that the stress is a mean over"),
      column(
          "in_cell", &GrainStress::in_cell, "",
          "1: the area is that of a closed Voronoi cell; 0: that of the disc, at a free surface and for fixed grains"),
  };
  constexpr const char* names[] = {"stress_xx", "stress_xy", "stress_yx", "stress_yy"};
  for (std::size_t k = 0; k < 4; ++k) {
    columns.push_back(column<GrainStress>(
        names[k], [=](const GrainStress& grain) { return grain.stress[k]; }, "M/T^2",
        "of its contacts: force times branch to its centre, over the area; compression positive"));
  }
  to.groups.push_back(analysis_group<Rows>({"grain_stress", "N", {}, columns}, [](const Measured& run) {
    return run.results.grain_stress.empty() ? nullptr : &run.results.grain_stress;
  }));
}

}  // namespace repose
