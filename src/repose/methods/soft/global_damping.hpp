// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/methods/soft/settings.hpp"

namespace repose::soft {

/// A change of one component of a velocity under Cundall's damping. The direction of motion is that in the middle of
/// the kick.
inline double locally_damped(double change, double before, double fraction) {
  const double power = change * (before + 0.5 * change);
  if (power == 0.0) return change;
  return change * (power > 0.0 ? 1.0 - fraction : 1.0 + fraction);
}
template <int D>
Vec<D> locally_damped(Vec<D> change, const Vec<D>& before, double fraction) {
  for (int k = 0; k < D; ++k) change[k] = locally_damped(change[k], before[k], fraction);
  return change;
}

/// The change of the velocities of a grain in a kick [T] with global damping, from the change without it and the
/// velocities before. The drag is that of the mean velocity over the kick, so it never reverses a motion.
template <int D>
HalfStep<D> damped(const GlobalDamping& damping, double kick, const HalfStep<D>& before, const HalfStep<D>& change) {
  HalfStep<D> with{locally_damped(change.velocity, before.velocity, damping.local),
                   locally_damped(change.rim_velocity, before.rim_velocity, damping.local)};
  const double drag = damping.viscous * kick;
  const double fraction = 1.0 / (1.0 + 0.5 * drag);
  with.velocity = (with.velocity - before.velocity * drag) * fraction;
  with.rim_velocity = (with.rim_velocity - before.rim_velocity * drag) * fraction;
  return with;
}

}  // namespace repose::soft
