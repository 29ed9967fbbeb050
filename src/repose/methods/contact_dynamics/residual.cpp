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

/// The violation of Signorini's condition and Coulomb's law at one contact [L/T].
struct Violation {
  double normal = 0.0;
  double tangential = 0.0;

  double worst() const { return std::max(normal, tangential); }
};

/// The natural map. Friction is limited by the projected normal impulse, so that a normal impulse that cannot be told
/// from zero does not allow infinite friction.
template <int D>
Violation natural_map(const ContactLine<D>& c, double opening, const Tangent<D>& slip) {
  const auto& p = c.impulse;
  const double normal = std::max(0.0, p.normal - c.normal_mass * opening);
  const Tangent<D> tangent = project(Tangent<D>(p.tangent - slip * c.tangent_mass), friction_limit(c.friction, normal));
  return {std::fabs(p.normal - normal) / c.normal_mass, magnitude(Tangent<D>(p.tangent - tangent)) / c.tangent_mass};
}

/// The violation of the sliding state of infinite friction: the contact touches, carries no normal impulse, and its
/// friction is opposite to the slip velocity.
template <int D>
Violation sliding_violation(const ContactLine<D>& c, double opening, const Tangent<D>& slip) {
  const double push = magnitude(c.impulse.tangent) / c.tangent_mass;
  const double speed = magnitude(slip);
  const double smaller = std::min(push, speed);
  double sine = 1.0;
  if (const double along = inner(c.impulse.tangent, slip) / c.tangent_mass; along < 0.0) {
    const double cosine = along / (push * speed);
    sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  }
  return {std::max(std::fabs(c.impulse.normal) / c.normal_mass, std::fabs(opening)), smaller * sine};
}

/// The torque impulse with the nearest parts within their limits: of rolling, and in 3D of twisting.
double project_roll(const ContactLine<2>& c, double roll) {
  return project(roll, friction_limit(c.rolling_friction, c.impulse.normal));
}
Vec<3> project_roll(const ContactLine<3>& c, const Vec<3>& roll) {
  const double twist = dot(roll, c.normal);
  return project(Vec<3>(roll - c.normal * twist), friction_limit(c.rolling_friction, c.impulse.normal)) +
         c.normal * project(twist, friction_limit(c.twisting.friction, c.impulse.normal));
}

/// The violations of all laws of one contact [L/T].
template <int D>
Residual violations(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b) {
  const double opening = opening_velocity(c, a, b) + c.normal_bias;
  const Tangent<D> slip = slip_velocity(c, a, b) + c.tangent_bias;
  const Spin<D> roll = roll_velocity(c, a, b);
  const auto& p = c.impulse;
  const Spin<D> turning = project_roll(c, Spin<D>(p.roll - roll * c.roll_mass));
  Violation violation = natural_map(c, opening, slip);
  if (std::isinf(c.friction)) {
    const Violation sliding = sliding_violation(c, opening, slip);
    if (sliding.worst() < violation.worst()) violation = sliding;
  }
  Residual all;
  all.normal = violation.normal;
  all.tangential = violation.tangential;
  all.rolling = magnitude(Spin<D>(p.roll - turning)) / c.roll_mass;
  all.complementarity = std::fabs(p.normal * opening) / c.normal_mass;
  return all;
}

template <int D>
double violation(const ContactLine<D>& c, const Body<D>& a, const Body<D>& b) {
  return violations(c, a, b).worst();
}

template <int D>
Residual residual(const Problem<D>& problem, std::vector<Body<D>>& bodies) {
  add_impulses(problem, bodies);
  Residual worst;
  // NaN counts as infinity.
  const auto take = [](double& largest, double value) {
    if (!(value <= largest)) largest = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  for (const auto& c : problem.contacts) {
    const auto all = violations(c, bodies[c.first], bodies[c.second]);
    take(worst.normal, all.normal);
    take(worst.tangential, all.tangential);
    take(worst.rolling, all.rolling);
    take(worst.complementarity, all.complementarity);
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
template double violation(const ContactLine<2>&, const Body<2>&, const Body<2>&);
template double violation(const ContactLine<3>&, const Body<3>&, const Body<3>&);
template Residual residual(const Problem<2>&, std::vector<Body<2>>&);
template Residual residual(const Problem<3>&, std::vector<Body<3>>&);

}  // namespace repose::contact_dynamics
