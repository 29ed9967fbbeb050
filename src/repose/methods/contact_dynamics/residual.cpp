// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/residual.hpp"

#include <cmath>
#include <limits>

namespace repose::contact_dynamics {

template <int D>
double velocity_scale(const Problem<D>& problem) {
  if (problem.velocity_scale > 0.0) return problem.velocity_scale;
  double scale = 0.0;
  for (const auto& c : problem.contacts) {
    const double formal = opening_velocity(c, problem.free[c.first], problem.free[c.second]) + c.normal_bias;
    scale = std::max({scale, -formal, std::fabs(c.impulse.normal) / c.normal_mass});
  }
  return scale > 0.0 ? scale : 1.0;
}

/// By how much a contact that slides under infinite friction drives its slip instead of braking it [L/T].
template <int D>
double off_sliding(const ContactLine<D>& c, const Tangent<D>& slip) {
  const Tangent<D> push = c.impulse.tangent * (1.0 / c.tangent_mass);
  const double size = std::max(magnitude(push), magnitude(slip));
  if (!(size > 0.0)) return 0.0;
  return magnitude(Tangent<D>(push + slip)) <= magnitude(Tangent<D>(push - slip))
             ? 0.0
             : std::min(magnitude(push), magnitude(slip));
}

template <int D>
Residual residual(const Problem<D>& problem, std::vector<Body<D>>& bodies) {
  add_impulses(problem, bodies);
  Residual worst;
  // What is not a number counts as worst of all.
  const auto take = [](double& largest, double value) {
    if (!(value <= largest)) largest = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  for (const auto& c : problem.contacts) {
    const auto& a = bodies[c.first];
    const auto& b = bodies[c.second];
    const double opening = opening_velocity(c, a, b) + c.normal_bias;
    const Tangent<D> slip = slip_velocity(c, a, b) + c.tangent_bias;
    const Spin<D> roll = roll_velocity(c, a, b);
    const auto& p = c.impulse;
    const double normal = std::max(0.0, p.normal - c.normal_mass * opening);
    const Tangent<D> tangent =
        project(Tangent<D>(p.tangent - slip * c.tangent_mass), friction_limit(c.friction, p.normal));
    const Spin<D> turning = project(Spin<D>(p.roll - roll * c.roll_mass), friction_limit(c.rolling_friction, p.normal));
    double off_normal = std::fabs(p.normal - normal) / c.normal_mass;
    double off_tangent = magnitude(Tangent<D>(p.tangent - tangent)) / c.tangent_mass;
    if (std::isinf(c.friction)) {
      const double sliding_normal = std::max(std::fabs(p.normal) / c.normal_mass, std::fabs(opening));
      const double sliding_tangent = off_sliding(c, slip);
      if (std::max(sliding_normal, sliding_tangent) < std::max(off_normal, off_tangent)) {
        off_normal = sliding_normal;
        off_tangent = sliding_tangent;
      }
    }
    take(worst.normal, off_normal);
    take(worst.tangential, off_tangent);
    take(worst.rolling, magnitude(Spin<D>(p.roll - turning)) / c.roll_mass);
    take(worst.complementarity, std::fabs(p.normal * opening) / c.normal_mass);
  }
  worst.scale = velocity_scale(problem);
  worst.normal /= worst.scale;
  worst.tangential /= worst.scale;
  worst.rolling /= worst.scale;
  worst.complementarity /= worst.scale * worst.scale;
  return worst;
}

template double velocity_scale(const Problem<2>&);
template double velocity_scale(const Problem<3>&);
template Residual residual(const Problem<2>&, std::vector<Body<2>>&);
template Residual residual(const Problem<3>&, std::vector<Body<3>>&);

}  // namespace repose::contact_dynamics
