// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <vector>

namespace repose::contact_dynamics {

/// The residual of impulses: the largest violation of each law, as a velocity over the scale of the problem.
///
/// The first three are the natural map |p - projection(p - m vbar)| / m, which is zero if and only if the law holds (it
/// also detects negative normal impulses and friction above its limit). Infinite friction is the limit of high
/// friction: a contact that touches, slides and carries no normal impulse may carry any friction against its slip;
/// without this some steps have no solution. The residual is independent of the solver: velocities are computed from
/// the impulses.
struct Residual {
  double normal = 0.0;
  double tangential = 0.0;
  double rolling = 0.0;
  double complementarity = 0.0;  ///< normal impulse times formal normal velocity, over mass and scale squared
  double scale = 0.0;            ///< [L/T] unit of the residuals

  double worst() const { return std::max({normal, tangential, rolling}); }
};

/// The residual of the impulses of a problem. `bodies` is working memory, and holds the velocities from the impulses
/// afterwards.
template <int D>
Residual residual(const Problem<D>& problem, std::vector<Body<D>>& bodies);

template <int D>
Residual residual(const Problem<D>& problem) {
  std::vector<Body<D>> bodies;
  return residual(problem, bodies);
}

/// The largest violation of the laws of one contact [L/T], given the velocities of its two bodies.
template <int D>
double violation(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b);

/// The unit of the residuals of a problem [L/T]: its own scale if it has one. Otherwise it is the largest formal
/// closing velocity without impulses, or the largest velocity that a present normal impulse gives to its contact alone,
/// if that is larger.
template <int D>
double velocity_scale(const Problem<D>& problem);

}  // namespace repose::contact_dynamics
