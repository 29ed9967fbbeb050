// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/soft_system.hpp"

#include "repose/core/grains.hpp"

#include <algorithm>
#include <cmath>

namespace repose::hybrid {

namespace {

Vec<2> unit(const Vec<2>& a) { return a * (1.0 / std::max(magnitude(a), std::numeric_limits<double>::min())); }

}  // namespace

void SoftSystem::begin(double length) {
  step = length;
  statics = false;
  straight = false;
  bodies.clear();
  pairs.clear();
}

bool SoftSystem::rolls() const {
  return !statics && slip_drag > 0.0 &&
         std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.friction > 0.0; });
}

void SoftSystem::time_pair(SoftPair& pair) const {
  const auto& first = bodies[pair.first];
  const double other = pair.second == nobody ? 0.0 : bodies[pair.second].entry;
  const double from = std::max(first.entry, other);
  pair.duration = pair.second == nobody ? first.duration : std::min(first.duration, bodies[pair.second].duration);
  pair.lag_first = statics ? 1.0 : pair.second == nobody ? 0.0 : (from - first.entry) / first.duration;
  pair.lag_second = statics ? 1.0 : pair.second == nobody ? 0.0 : (from - other) / bodies[pair.second].duration;
}

SoftSystem::Places SoftSystem::places(const SoftPair& pair) const {
  const Vec<2> of_first = bodies[pair.first].moved;
  const Vec<2> of_second = pair.second == nobody ? Vec<2>{} : bodies[pair.second].moved;
  Places found;
  found.before = pair.apart + of_first * pair.lag_first - of_second * pair.lag_second;
  found.after = pair.apart + of_first - of_second;
  if (pair.at_wall()) {
    found.along = pair.normal;
    found.distance_before = dot(found.before, pair.normal);
    found.distance_after = dot(found.after, pair.normal);
  } else {
    found.distance_before = magnitude(found.before);
    found.distance_after = magnitude(found.after);
    const double sum = found.distance_before + found.distance_after;
    found.along = (found.before + found.after) * (1.0 / std::max(sum, std::numeric_limits<double>::min()));
  }
  return found;
}

double SoftSystem::slip(const SoftPair& pair, const Vec<2>& tangent) const {
  const auto& first = bodies[pair.first];
  double speed = (dot(first.moved, tangent) - first.rolled) / first.duration;
  if (pair.second != nobody) {
    const auto& second = bodies[pair.second];
    speed -= (dot(second.moved, tangent) + second.rolled) / second.duration;
  }
  return speed;
}

/// The force of friction over the slip speed [M/T]: the weaker of viscous sliding and rolling friction.
double SoftSystem::drag(const SoftPair& pair, double slip) const {
  const double most = pair.friction * std::max(0.0, pair.normal_force);
  const double speed = std::fabs(slip);
  return slip_drag * speed <= most ? slip_drag : most / speed;
}

Vec<2> SoftSystem::act(SoftPair& pair) const {
  const auto at = places(pair);
  const auto mean = mean_force(statics ? Spring{spring.stiffness, 0.0} : spring, pair.reach - at.distance_before,
                               pair.reach - at.distance_after, pair.duration);
  pair.normal_force = mean.force;
  Vec<2> force = at.along * mean.force;
  pair.friction_force = 0.0;
  pair.well_force = 0.0;
  const double pressing = std::max(0.0, mean.force);
  if (!statics && pair.friction > 0.0 && slip_drag > 0.0 && pressing > 0.0) {
    const Vec<2> tangent = in_space(1.0, unit(at.along));
    const double speed = slip(pair, tangent);
    pair.friction_force = -drag(pair, speed) * speed;
    force += tangent * pair.friction_force;
  }
  if (pair.well > 0.0) {
    const Vec<2> tangent = in_space(1.0, pair.normal);
    const double off = pair.off_anchor + 0.5 * (1.0 + pair.lag_first) * dot(bodies[pair.first].moved, tangent);
    pair.well_force = -pair.well * pressing * off;
    force += tangent * pair.well_force;
  }
  pair.force = force;
  return force * fraction_of_step(pair);
}

PairSlopes SoftSystem::slopes(const SoftPair& pair) const {
  const auto at = places(pair);
  const auto mean = mean_force(statics ? Spring{spring.stiffness, 0.0} : spring, pair.reach - at.distance_before,
                               pair.reach - at.distance_after, pair.duration);
  const double part = fraction_of_step(pair);
  Symmetric before;
  Symmetric after;
  const auto add = [&](Symmetric& to, double by, const Vec<2>& normal) {
    to.add(at.along, normal, part * by);
    if (pair.at_wall() || straight) return;
    const double turn = part * mean.force / (at.distance_before + at.distance_after);
    to.add(at.along, normal, turn);
    to.xx -= turn;
    to.yy -= turn;
  };
  // A larger separation is a smaller overlap: minus the derivative of the force is the derivative by the overlap.
  add(before, mean.by_before, pair.at_wall() ? pair.normal : unit(at.before));
  add(after, mean.by_after, pair.at_wall() ? pair.normal : unit(at.after));
  const auto sum = [&](double lag) {
    return Symmetric{after.xx + lag * before.xx, after.xy + lag * before.xy, after.yy + lag * before.yy};
  };
  PairSlopes found;
  found.first = sum(pair.lag_first);
  found.second = sum(pair.lag_second);
  found.both = sum(std::min(pair.lag_first, pair.lag_second));
  const double pressing = std::max(0.0, mean.force);
  if (pair.well > 0.0) {
    const Vec<2> tangent = in_space(1.0, pair.normal);
    found.first.add(tangent, tangent, part * pair.well * pressing * 0.5 * (1.0 + pair.lag_first));
  }
  if (!statics && pair.friction > 0.0 && slip_drag > 0.0 && pressing > 0.0) {
    found.tangent = in_space(1.0, unit(at.along));
    const double strength = part * drag(pair, slip(pair, found.tangent));
    found.drag_first = strength / bodies[pair.first].duration;
    if (pair.second != nobody) found.drag_second = strength / bodies[pair.second].duration;
    found.drag_both = std::min(found.drag_first, found.drag_second);
    found.first.add(found.tangent, found.tangent, found.drag_first);
    found.second.add(found.tangent, found.tangent, found.drag_second);
    found.both.add(found.tangent, found.tangent, found.drag_both);
  }
  return found;
}

Vec<2> SoftSystem::own_unbalanced(const SoftBody& body) const {
  const Vec<2> velocity = statics ? Vec<2>{} : body.velocity;
  const Vec<2> change = (body.mean_velocity() - velocity) * 2.0;
  return (change - gravity * body.duration) * (body.mass / step);
}

double SoftSystem::own_turn(const SoftBody& body) const {
  return 2.0 * (body.rolled / body.duration - body.rim_velocity) * body.mass / (inverse_inertia_factor<2> * step);
}

void SoftSystem::balance() {
  unbalanced.resize(bodies.size());
  unbalanced_turn.assign(bodies.size(), 0.0);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    unbalanced[k] = own_unbalanced(bodies[k]);
    if (!statics) unbalanced_turn[k] = own_turn(bodies[k]);
  }
  for (auto& pair : pairs) {
    const Vec<2> force = act(pair);
    const double turn = turning(pair);
    unbalanced[pair.first] -= force;
    unbalanced_turn[pair.first] += turn;
    if (pair.second == nobody) continue;
    unbalanced[pair.second] += force;
    unbalanced_turn[pair.second] += turn;
  }
}

SoftSystem::Worst SoftSystem::worst() const {
  Worst found{0.0, bodies.empty() ? nobody : 0};
  const bool rolling = rolls();
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    const double x = bodies[k].pinned ? 0.0 : std::fabs(unbalanced[k][0]);
    double largest = std::max(x, std::fabs(unbalanced[k][1]));
    if (rolling) largest = std::max(largest, std::fabs(unbalanced_turn[k]));
    if (!std::isfinite(x + unbalanced[k][1])) largest = std::numeric_limits<double>::infinity();
    if (largest > found.residual) found = {largest, k};
  }
  found.residual /= weight;
  return found;
}

double SoftSystem::sum_of_squares() const {
  double sum = 0.0;
  const bool rolling = rolls();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!bodies[k].pinned) sum += unbalanced[k][0] * unbalanced[k][0];
    sum += unbalanced[k][1] * unbalanced[k][1];
    if (rolling) sum += unbalanced_turn[k] * unbalanced_turn[k];
  }
  return sum / (weight * weight);
}

}  // namespace repose::hybrid
