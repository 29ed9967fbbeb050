// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repose::contact_dynamics {

namespace {

/// The positions of bodies with several impacts in one step are found by this many passes over the impacts.
constexpr int position_passes = 4;

/// The first time at which gap + speed t + acceleration t^2 / 2 is zero, for a gap that closes; at most `longest`.
double closing_time(double gap, double speed, double acceleration, double longest) {
  if (gap <= 0.0) return 0.0;
  const double root = std::sqrt(std::max(0.0, speed * speed - 2.0 * acceleration * gap));
  const double time = 2.0 * gap / (root - speed);
  return time >= 0.0 && time < longest ? time : longest;
}

}  // namespace

/// Sets the time of each impact and, for each body, that of its first impact.
template <int D>
void Impacts<D>::find_times(const std::vector<Body<D>>& before, const StepTimes& times, const Problem<D>& problem) {
  const auto bodies = problem.free.size();
  acceleration_.resize(bodies);
  for (std::size_t k = 0; k < bodies; ++k) {
    acceleration_[k] = (problem.free[k].velocity - before[k].velocity) * (1.0 / times.kick());
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  flown_.assign(bodies, never);
  closing_times_.clear();
  for (const auto& closing : closing_) {
    const auto& c = problem.contacts[closing.contact];
    const double acceleration = dot(Vec<D>(acceleration_[c.first] - acceleration_[c.second]), c.normal);
    const double speed = opening_velocity(c, before[c.first], before[c.second]) + acceleration * times.lag;
    const double time = closing_time(closing.gap, speed, acceleration, times.step);
    closing_times_.push_back(time);
    for (const auto body : {c.first, c.second}) {
      flown_[body] = std::min(flown_[body], times.lag + time);
    }
  }
  std::replace(flown_.begin(), flown_.end(), never, 0.0);
}

template <int D>
ImpactReport Impacts<D>::act(const std::vector<Body<D>>& before, const StepTimes& times, const Collisions& collisions,
                             Problem<D>& problem) {
  closing_ = collisions.closing;
  impulses_.clear();
  if (closing_.empty()) return {};
  find_times(before, times, problem);
  Problem<D> impact = problem;
  for (std::size_t k = 0; k < impact.free.size(); ++k) {
    impact.free[k].velocity = before[k].velocity + acceleration_[k] * flown_[k];
  }
  for (auto& c : impact.contacts) {
    c.impulse = {};
    c.normal_bias = std::max(0.0, c.normal_bias);
  }
  std::vector<Rebound<D>> rebounds;
  double fastest = 0.0;
  for (const auto& one : closing_) {
    const auto& c = impact.contacts[one.contact];
    const auto &a = impact.free[c.first], &b = impact.free[c.second];
    const double speed = std::min(0.0, opening_velocity(c, a, b));
    rebounds.push_back({one.contact, one.restitution * speed, slip_velocity(c, a, b) * one.tangential_restitution});
    impact.contacts[one.contact].normal_bias = 0.0;
    fastest = std::max({fastest, -speed, magnitude(slip_velocity(c, a, b))});
  }
  for (const auto& one : collisions.opening) {
    auto& c = impact.contacts[one.contact];
    const double speed = opening_velocity(c, impact.free[c.first], impact.free[c.second]);
    c.normal_bias = std::max(c.normal_bias, one.restitution * speed);
  }
  impact.velocity_scale = std::max(problem.velocity_scale, fastest);
  const auto report = solve_impact(rebounds, solver_, impact);
  late_.assign(problem.free.size(), 0);
  for (std::size_t k = 0; k < closing_.size(); ++k) {
    const auto& c = impact.contacts[closing_[k].contact];
    if (c.impulse.normal > 0.0 && closing_times_[k] > 0.5 * times.step) late_[c.first] = late_[c.second] = 1;
  }
  // A body that rebounds in the second half of the step has flown for longer than its velocities are advanced. It
  // rebounds half a step after the start instead: its path is a little early, and as high.
  for (std::size_t k = 0; k < problem.free.size(); ++k) {
    const double rest = times.kick() - flown_[k];
    problem.free[k].velocity = impact.bodies[k].velocity + acceleration_[k] * (late_[k] ? std::max(0.0, rest) : rest);
    problem.free[k].rim_velocity = impact.bodies[k].rim_velocity;
  }
  for (const auto& c : impact.contacts) impulses_.push_back(c.impulse);
  return report;
}

template <int D>
const std::vector<Vec<D>>& Impacts<D>::displacements(const StepTimes& times, const Problem<D>& problem,
                                                     const std::vector<Body<D>>& bodies) {
  displacements_.clear();
  if (impulses_.empty()) return displacements_;
  displacements_.assign(problem.free.size(), Vec<D>{});
  for (int pass = 0; pass < position_passes; ++pass) {
    for (std::size_t k = 0; k < closing_.size(); ++k) {
      const auto& c = problem.contacts[closing_[k].contact];
      const double first = problem.free[c.first].inverse_mass;
      const double second = c.second < problem.first_wall ? problem.free[c.second].inverse_mass : 0.0;
      const double weight = first + second;
      // Between two free bodies this would change their angular momentum by the slip times the displacement.
      if (first > 0.0 && second > 0.0) continue;
      if (!(impulses_[closing_[k].contact].normal > 0.0) || closing_[k].gap <= 0.0 || !(weight > 0.0)) continue;
      const double opening = opening_velocity(c, bodies[c.first], bodies[c.second]);
      const double turned = std::min(closing_times_[k], 0.5 * times.step);
      const double left = times.step - turned;
      const double acceleration = dot(Vec<D>(acceleration_[c.first] - acceleration_[c.second]), c.normal);
      const double wanted = std::max(0.0, opening * left + 0.5 * acceleration * turned * left);
      const double moved = dot(Vec<D>(displacements_[c.first] - displacements_[c.second]), c.normal);
      const double missing = wanted - (closing_[k].gap + opening * times.step + moved);
      if (!(missing < 0.0)) continue;
      displacements_[c.first] += c.normal * (missing * first / weight);
      displacements_[c.second] -= c.normal * (missing * second / weight);
    }
  }
  return displacements_;
}

template class Impacts<2>;
template class Impacts<3>;

}  // namespace repose::contact_dynamics
