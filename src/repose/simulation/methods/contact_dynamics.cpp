// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

#include "repose/scene/geometry.hpp"
#include "repose/scene/methods/contact_dynamics.hpp"

namespace repose {

namespace {

template <int D>
ContactDynamicsSettings<D> settings_of(const ContactDynamicsMethod& method, const Scene& scene) {
  ContactDynamicsSettings<D> settings;
  settings.time_step = method.time_step(scene);
  settings.gravity = scene.gravity_vector<D>();
  settings.box = make_box<D>(scene);
  settings.walls = make_walls<D>(scene);
  if (const auto limit = method.speed_limit(scene)) settings.speed_limit = *limit;
  settings.solver.tolerance = method.limits.tolerance;
  settings.solver.most_sweeps = method.limits.most_sweeps;
  settings.solver.accelerated = method.algorithm == "accelerated";
  settings.warm_start = method.warm_start == "never"     ? WarmStart::never
                        : method.warm_start == "settled" ? WarmStart::settled
                                                         : WarmStart::always;
  settings.overlap_recovery = method.overlap_recovery;
  settings.skin = method.skin;
  return settings;
}

}  // namespace

std::unique_ptr<Method<2>> ContactDynamicsMethod::make(const Scene& scene, Dimension<2>) const {
  return make_contact_dynamics<2>(scene.impulse_laws(), settings_of<2>(*this, scene));
}
std::unique_ptr<Method<3>> ContactDynamicsMethod::make(const Scene& scene, Dimension<3>) const {
  return make_contact_dynamics<3>(scene.impulse_laws(), settings_of<3>(*this, scene));
}

}  // namespace repose
