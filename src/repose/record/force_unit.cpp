// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/record/force_unit.hpp"

#include "repose/analysis/force_network.hpp"

#include <fmt/format.h>

namespace repose {

template <int D>
double force_unit(const Scene& scene, const Contacts<D>& contacts) {
  if (scene.analysis.force_scale == "given") return scene.analysis.force;
  return scene.analysis.force_scale == "mean" ? mean_normal_force(contacts) : scene.grain_weight();
}
template double force_unit(const Scene&, const Contacts<2>&);
template double force_unit(const Scene&, const Contacts<3>&);

std::string force_unit_name(const Scene& scene) {
  if (scene.analysis.force_scale == "given") return fmt::format("times {:g} M L/T^2", scene.analysis.force);
  return scene.analysis.force_scale == "mean" ? "mean forces" : "grain weights";
}

double burst_threshold(const Scene& scene, double force_unit) {
  return scene.analysis.burst * force_unit * scene.grains.diameter;
}

}  // namespace repose
