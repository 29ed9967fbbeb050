// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace repose::hybrid {

/// The spring and dashpot of a soft contact.
struct Spring {
  double stiffness = 0.0;  ///< [M/T^2] K_s
  double damping = 0.0;    ///< [M/T] K_D
};

/// Elastic energy [M L^2/T^2] at an overlap [L]; none while apart.
/// Source: Liffman, Chan and Hughes (1992), (23).
inline double elastic_energy(const Spring& spring, double overlap) {
  const double pressed = std::max(0.0, overlap);
  return 0.5 * spring.stiffness * pressed * pressed;
}

/// A mean normal force over a step and its derivatives by the overlaps at the end and at the start of it.
struct MeanForce {
  double force = 0.0;     ///< [M L/T^2] positive pushes apart
  double by_after = 0.0;  ///< [M/T^2]
  double by_before = 0.0;
};

/// The mean force over a step of a length [T] in which the overlap goes from `before` to `after` [L]: the change of
/// elastic energy over the change of overlap, so that the energy is conserved to rounding, and the impulse of the
/// dashpot in the part of the step in which the bodies overlap.
/// Source: (24), which holds where both overlaps are positive, and (25); docs/physics/hybrid.md.
/// Validated by tests/unit/hybrid_soft_test.cpp.
inline MeanForce mean_force(const Spring& spring, double before, double after, double length) {
  const double a = std::max(0.0, before);
  const double b = std::max(0.0, after);
  MeanForce mean;
  if (before >= 0.0 && after >= 0.0) {
    mean.force = 0.5 * spring.stiffness * (a + b);
    mean.by_after = mean.by_before = 0.5 * spring.stiffness;
  } else if (a > 0.0 || b > 0.0) {
    const double change = after - before;
    const double fraction = (b - a) / change;  // of the change, that happened while they overlap
    mean.force = 0.5 * spring.stiffness * (a + b) * fraction;
    mean.by_after = (spring.stiffness * b - mean.force) / change;
    mean.by_before = (mean.force - spring.stiffness * a) / change;
  }
  mean.force += spring.damping * (b - a) / length;
  if (after > 0.0) mean.by_after += spring.damping / length;
  if (before > 0.0) mean.by_before -= spring.damping / length;
  return mean;
}

}  // namespace repose::hybrid
