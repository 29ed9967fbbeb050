// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/team.hpp"
#include "repose/methods/soft/kernels.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

namespace repose::testing {

/// Grains under the soft method at positions that a test chooses.
template <int D, class Law>
class SoftWorld {
 public:
  SoftWorld(Law law, SoftSettings<D> settings, int threads = 1)
      : SoftWorld(MaterialTable<Law>(law), settings, threads) {}
  SoftWorld(MaterialTable<Law> laws, SoftSettings<D> settings, int threads = 1)
      : method_(make_kernel<D, Law>(laws, settings)), team_(threads) {}

  /// Adds a grain and returns its id. The mass is 4 r^2: 1 for radius 1/2.
  std::int64_t add(Vec<D> position, Vec<D> velocity = {}, Spin<D> spin = {}, double radius = 0.5, bool fixed = false,
                   std::uint16_t material = 0) {
    Grain<D> grain;
    grain.position = position;
    grain.radius = radius;
    grain.mass = 4.0 * radius * radius;
    if (!fixed) {
      grain.velocity = velocity;
      grain.rim_velocity = spin * radius;
      grain.inverse_mass = 1.0 / grain.mass;
    }
    grains.add(grain, static_cast<std::int64_t>(grains.size()), fixed, material);
    method_->grains_added(grains);
    return grains.id.back();
  }

  StepReport advance(long steps) {
    const double duration = static_cast<double>(steps) * method_->time_steps().length;
    return method_->advance(grains, method_->time() + duration, team_);
  }
  Contacts<D> contacts() const { return method_->contacts(grains); }
  void refresh() { method_->refresh(grains, team_); }
  const Method<D>& method() const { return *method_; }
  std::vector<Vec<D>> take_wall_impulses() { return method_->take_wall_impulses(); }
  void set_loads(const std::vector<Load<D>>& loads) { method_->set_loads(loads); }
  Energy energy() const { return method_->energy(grains); }

  /// The grain with this id.
  Grain<D>& operator[](std::int64_t id) {
    for (std::size_t k = 0; k < grains.size(); ++k) {
      if (grains.id[k] == id) return grains.line[k];
    }
    throw std::out_of_range("no such grain");
  }

  Grains<D> grains;

 private:
  std::unique_ptr<Method<D>> method_;
  Team team_;
};

inline SoftSettings<2> settings_2d(double time_step, double gravity) {
  SoftSettings<2> settings;
  settings.time_step = time_step;
  settings.gravity = {{0.0, -gravity}};
  return settings;
}

}  // namespace repose::testing
