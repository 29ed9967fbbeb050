// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <vector>

namespace repose::contact_dynamics {

/// By how much impulses miss the laws: velocities over the scale of the problem, the worst contact of each kind.
///
/// The first three are the natural map |p - projection(p - m vbar)| / m, zero if and only if the law holds (also for a
/// negative normal impulse, a friction beyond its limit). Infinite friction is the limit of high friction: a contact
/// that is pressed by nothing, touches and slides may carry any friction against its slip. Without it some steps have
/// no solution. They know nothing of the solver: velocities are summed up from the impulses.
struct Residual {
  double normal = 0.0;
  double tangential = 0.0;
  double rolling = 0.0;
  double complementarity = 0.0;  ///< normal impulse times formal normal velocity, over mass and scale squared
  double scale = 0.0;            ///< [L/T] what the velocities are measured by

  double worst() const { return std::max({normal, tangential, rolling}); }
};

/// `bodies` is room to work in: afterwards it holds the velocities that go with the impulses.
template <int D>
Residual residual(const Problem<D>& problem, std::vector<Body<D>>& bodies);

template <int D>
Residual residual(const Problem<D>& problem) {
  std::vector<Body<D>> bodies;
  return residual(problem, bodies);
}

/// What velocities of this problem are measured by [L/T]: its own scale where it has one, else the largest formal
/// velocity of closing without impulses, or what the present impulses would make of a single contact at rest.
template <int D>
double velocity_scale(const Problem<D>& problem);

}  // namespace repose::contact_dynamics
