// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/describe.hpp"
#include "repose/record/force_unit.hpp"

#include <fmt/format.h>

namespace repose {

std::string describe_result(const Record<3>& record, const Results<3>& results) {
  std::string text = describe_end(record);
  if (results.packing) {
    const auto& packing = *results.packing;
    text += fmt::format("slab             z {:.4g} to {:.4g}, {} spheres in it\n", results.slab->low,
                        results.slab->high, packing.spheres);
    text +=
        fmt::format("solid fraction   {:.4f} +- {:.4f}\n", packing.solid_fraction.mean, packing.solid_fraction.error);
    text += fmt::format("touching         {:.4f} +- {:.4f} neighbours\n", packing.coordination.mean,
                        packing.coordination.error);
  }
  const auto& cone = results.cone;
  if (cone.line) {
    text += fmt::format("angle of repose  {:.2f}; sectors {:.2f} +- {:.2f}; moments {} deg\n", cone.line->angle_deg,
                        cone.angle_deg.mean, cone.angle_deg.error,
                        cone.moments_angle_deg ? fmt::format("{:.2f}", *cone.moments_angle_deg) : "-");
  }
  if (!record.scene.method->traits().has_forces()) return text;
  if (results.network.coordination) {
    text += fmt::format("coordination     {:.3f} (contacts above {:g} {})\n", *results.network.coordination,
                        record.scene.analysis.force_threshold, force_unit_name(record.scene));
  }
  if (results.core.grains > 0) {
    text += fmt::format("core             {} grains, solid fraction {:.4f}, coordination {:.3f}\n", results.core.grains,
                        *results.core.solid_fraction, *results.core.coordination);
  }
  if (results.base.dip_index) {
    text +=
        fmt::format("dip index        {:.3f} +- {:.3f}\n", results.base.dip_index->mean, results.base.dip_index->error);
  }
  if (results.column) text += describe_column(*results.column);
  text += fmt::format("deepest overlap  {:.4f} diameters\n", results.max_overlap);
  if (results.weight_error) text += fmt::format("weight error     {:.2e}\n", *results.weight_error);
  return text;
}

}  // namespace repose
