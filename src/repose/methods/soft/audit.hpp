// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/energy.hpp"
#include "repose/core/grains.hpp"
#include "repose/laws/any_law.hpp"
#include "repose/methods/soft/settings.hpp"

#include <cstddef>

/// The energy budget. Force times the mean velocity over a kick is the exact change of kinetic energy. So the work of
/// dashpots and friction is summed kick by kick, separately for each grain, and the sums do not depend on the number of
/// threads.
namespace repose::soft {

/// The energy that dissipative forces have removed from a grain [M L^2/T^2], counted positive.
struct GrainWork {
  double damping = 0.0;
  double friction = 0.0;
  double walls = 0.0;
  double drag = 0.0;
};

inline void add(Energy& account, const GrainWork& work) {
  account.damping += work.damping;
  account.friction += work.friction;
  account.walls += work.walls;
  account.drag += work.drag;
}

/// The energy in the spring of a contact about its normal; 0 of discs.
template <int D, class Law>
double twist_energy(const Law& law, const Touch<double>& touch, const NormalForce<double>& normal, double twist) {
  if constexpr (D == 3) return energy_of_twist(law.twisting, touch, normal, twist);
  return 0.0;
}

/// Adds the kinetic and gravitational energy of a grain at the time of its velocity, which is `back` [T] before its
/// position.
template <int D>
void add_own(Energy& account, const Grains<D>& grains, std::size_t i, const SoftSettings<D>& settings, double back) {
  auto grain = grains.line[i];
  if (settings.synchronised) {
    grain.velocity = grains.half_step[i].velocity;
    grain.rim_velocity = grains.half_step[i].rim_velocity;
  }
  grain.position -= grain.velocity * back;
  account.kinetic += kinetic_energy(grain);
  account.gravitational -= grain.mass * dot(settings.gravity, grain.position);
}

/// The sum of both; 0 for a fixed grain.
template <int D>
double own_energy(const Grains<D>& grains, std::size_t i, const SoftSettings<D>& settings, double back) {
  if (grains.line[i].fixed()) return 0.0;
  Energy own;
  add_own(own, grains, i, settings, back);
  return own.kinetic + own.gravitational;
}

}  // namespace repose::soft
