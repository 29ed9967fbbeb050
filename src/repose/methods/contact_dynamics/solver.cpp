// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/solver.hpp"

#include "repose/methods/contact_dynamics/residual.hpp"

#include <algorithm>
#include <cmath>

namespace repose::contact_dynamics {

namespace {

/// Solves one contact as if the others held still. Normal and tangential parts of a disc or sphere do not act on each
/// other but through the friction limit; rolling comes after, from the turned bodies.
template <bool Rolling, int D>
REPOSE_FN void relax(ContactLine<D>& c, Body<D>& a, Body<D>& b) {
  auto& p = c.impulse;
  const double opening = opening_velocity(c, a, b) + c.normal_bias;
  const Tangent<D> slip = slip_velocity(c, a, b) + c.tangent_bias;
  const double normal = std::max(0.0, p.normal - c.normal_mass * opening);
  const Tangent<D> tangent = project(Tangent<D>(p.tangent - slip * c.tangent_mass), friction_limit(c.friction, normal));
  push(c, normal - p.normal, Tangent<D>(tangent - p.tangent), a, b);
  p.normal = normal;
  p.tangent = tangent;
  if constexpr (Rolling) {
    const Spin<D> roll = project(Spin<D>(p.roll - roll_velocity(c, a, b) * c.roll_mass),
                                 friction_limit(c.rolling_friction, normal));
    turn(c, Spin<D>(roll - p.roll), a, b);
    p.roll = roll;
  }
}

template <bool Rolling, int D>
void sweep_to_and_fro(Problem<D>& problem) {
  auto* bodies = problem.bodies.data();
  for (auto& c : problem.contacts) relax<Rolling>(c, bodies[c.first], bodies[c.second]);
  for (auto c = problem.contacts.rbegin(); c != problem.contacts.rend(); ++c)
    relax<Rolling>(*c, bodies[c->first], bodies[c->second]);
}

template <int D>
Body<D> difference(const Body<D>& a, const Body<D>& b) {
  return {a.velocity - b.velocity, a.rim_velocity - b.rim_velocity, 0.0};
}

}  // namespace

template <int D>
void Solver<D>::begin(const Problem<D>& problem) {
  before_.clear();
  for (const auto& c : problem.contacts) before_.push_back(c.impulse);
  bodies_before_ = problem.bodies;
  direction_.assign(problem.contacts.size(), {});
  bodies_direction_.assign(problem.bodies.size(), {});
  previous_squared_change_ = 0.0;
}

template <int D>
double Solver<D>::measure(const Problem<D>& problem) {
  double sum = 0.0;
  double worst = 0.0;
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    const auto& c = problem.contacts[k];
    const auto change = c.impulse - before_[k];
    sum += squared(change);
    worst = std::max({worst, std::fabs(change.normal) / c.normal_mass, magnitude(change.tangent) / c.tangent_mass});
  }
  squared_change_ = sum;
  return worst;
}

/// Goes on in the conjugate direction; starts anew from plain sweeps where they have come to change more than before.
template <int D>
void Solver<D>::extrapolate(Problem<D>& problem) {
  const double ratio = previous_squared_change_ > 0.0 ? squared_change_ / previous_squared_change_ : 0.0;
  const double share = ratio <= 1.0 ? ratio : 0.0;
  previous_squared_change_ = squared_change_;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    auto& now = problem.contacts[k].impulse;
    const auto old_direction = direction_[k] * share;
    direction_[k] = now - before_[k];
    direction_[k] += old_direction;
    now += old_direction;
    before_[k] = now;
  }
  for (std::size_t k = 0; k < bodies_before_.size(); ++k) {
    auto& now = problem.bodies[k];
    auto& direction = bodies_direction_[k];
    const auto change = difference(now, bodies_before_[k]);
    const Vec<D> old_velocity = direction.velocity * share;
    const Spin<D> old_rim = direction.rim_velocity * share;
    direction.velocity = change.velocity + old_velocity;
    direction.rim_velocity = change.rim_velocity + old_rim;
    now.velocity += old_velocity;
    now.rim_velocity += old_rim;
    bodies_before_[k] = now;
  }
}

template <int D>
Solution Solver<D>::solve(Problem<D>& problem) {
  Solution solution;
  add_impulses(problem.free, problem.contacts, problem.bodies);
  const double enough = settings_.tolerance * velocity_scale(problem);
  begin(problem);
  solution.residual = problem.contacts.empty() ? 0.0 : residual(problem, scratch_).worst();
  while (!(solution.residual <= settings_.tolerance) && solution.sweeps < settings_.most_sweeps) {
    if (problem.rolling)
      sweep_to_and_fro<true>(problem);
    else
      sweep_to_and_fro<false>(problem);
    ++solution.sweeps;
    const double change = measure(problem);
    // The true residual costs half a sweep: looked at when it may be small enough, or at the end.
    if (change <= enough || solution.sweeps == settings_.most_sweeps) {
      solution.residual = residual(problem, scratch_).worst();
      if (solution.residual <= settings_.tolerance || solution.sweeps == settings_.most_sweeps) break;
    }
    if (settings_.accelerated) {
      extrapolate(problem);
    } else {
      for (std::size_t k = 0; k < before_.size(); ++k) before_[k] = problem.contacts[k].impulse;
    }
  }
  if (!problem.contacts.empty()) add_impulses(problem.free, problem.contacts, problem.bodies);
  solution.converged = solution.residual <= settings_.tolerance;
  return solution;
}

template class Solver<2>;
template class Solver<3>;

}  // namespace repose::contact_dynamics
