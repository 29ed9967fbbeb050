// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/step.hpp"

#include <algorithm>
#include <cmath>

namespace repose::hybrid {

Step::Step(const Surroundings& around, Grains<2>& grains, Touches& touches, SoftSystem& system, DirectSolver& solver,
           double length)
    : wall_impulses(around.settings.walls.size()),
      around_(around),
      settings_(around.settings),
      grains_(grains),
      touches_(touches),
      system_(system),
      solver_(solver),
      length_(length),
      since_(grains.size()),
      version_(grains.size()) {
  system_.begin(length_);
  gather_bodies(around_, grains_, touches_, length_, system_);
  body_ = bodies_of(grains_, system_);
  const auto flying = static_cast<std::int64_t>(moving_count(grains_) - system_.bodies.size());
  constexpr std::int64_t of_each = 30;
  most_events_ = of_each * flying + 100;
}

bool Step::take() {
  account.steps = 1;
  if (!system_.bodies.empty()) {
    gather_pairs(around_, grains_, touches_, body_, system_);
    if (!solve()) return false;
  }
  find_events(0.0);
  while (!events_.empty()) {
    const auto event = events_.top();
    events_.pop();
    const auto other = event.partner < 0 ? nobody : static_cast<std::uint32_t>(event.partner);
    if (event.version != version_[event.grain]) continue;
    if (other != nobody && event.partner_version != version_[other]) continue;
    const bool soft = meet(event);
    ++version_[event.grain];
    if (soft) soften(event.grain, event.partner, event.time);
    if (outdated_) {
      gather_pairs(around_, grains_, touches_, body_, system_);
      if (!solve()) return false;
      find_events(event.time);
      continue;
    }
    find_events_of(event.grain, event.time);
    if (other == nobody || !flies(other)) continue;
    ++version_[other];
    find_events_of(other, event.time);
  }
  finish();
  return true;
}

void Step::add_body(std::uint32_t grain, double time) {
  const auto body = body_of(around_, grains_, grain, time, length_);
  const auto place = std::lower_bound(system_.bodies.begin(), system_.bodies.end(), grain,
                                      [](const SoftBody& one, std::uint32_t index) { return one.grain < index; });
  system_.bodies.insert(place, body);
  body_ = bodies_of(grains_, system_);
  outdated_ = true;
}

bool Step::solve() {
  const Profile::Stage stage(around_.profile, "solver");
  outdated_ = false;
  const auto solved = hybrid::solve(settings_, solver_, system_, settings_.tolerance, false);
  account.iterations += solved.iterations;
  if (solved.converged) {
    account.worst_residual = std::max(account.worst_residual, solved.residual);
  } else {
    unsolved = solved.worst == nobody ? nobody : system_.bodies[solved.worst].grain;
  }
  return solved.converged;
}

void Step::finish() {
  for (std::uint32_t k = 0; k < grains_.size(); ++k) {
    if (flies(k)) fly(k, length_);
  }
  for (const auto& body : system_.bodies) {
    auto& line = grains_.line[body.grain];
    line.position = body.start + body.moved;
    line.velocity = body.end_velocity();
    line.rim_velocity = body.end_rim_velocity();
    if (body.pinned) line.velocity[0] = 0.0;
  }
  keep_touches();
}

/// The contacts that remain soft: those that overlap at the end, and those that do not part.
void Step::keep_touches() {
  Touches kept;
  std::int64_t lasting = 0;
  for (const auto& pair : system_.pairs) {
    const auto& body = system_.bodies[pair.first];
    const auto& line = grains_.line[body.grain];
    auto touch = touch_between(body.grain, pair.partner);
    const Vec<2> force = system_.force_on_first(pair);
    Vec<2> n = pair.normal;
    double overlap = pair.reach;
    Vec<2> velocity = line.velocity;
    if (pair.at_wall()) {
      overlap -= dot(line.position - settings_.walls[wall_of(pair.partner)].point, n);
    } else {
      const auto& other = grains_.line[static_cast<std::size_t>(pair.partner)];
      n = separation(line.position, other.position, settings_.box);
      const double distance = magnitude(n);
      n *= 1.0 / distance;
      overlap -= distance;
      if (!other.fixed()) velocity -= other.velocity;
    }
    deepest = std::max(deepest, overlap / pair.reach);
    const double fraction = system_.fraction_of_step(pair);
    touch.normal_force = fraction * pair.normal_force;
    touch.tangential_force = fraction * (pair.friction_force + pair.well_force);
    if (pair.at_wall()) {
      Vec<2> on_wall = force;
      if (body.pinned) {
        const Vec<2> pin{{system_.unbalanced[pair.first][0], 0.0}};
        on_wall += pin;
        touch.tangential_force += dot(pin, wall_tangent(settings_.walls[wall_of(pair.partner)]));
      }
      wall_impulses[wall_of(pair.partner)] -= on_wall * length_;
    } else if (pair.second == nobody) {
      grains_.reaction[static_cast<std::size_t>(pair.partner)] -= force * length_;
    }
    const auto* old = touches_.find(touch.grain, touch.partner);
    const bool parts = dot(velocity, n) > 0.0;
    if (!(overlap > 0.0) && (old == nullptr || parts)) continue;
    const double along = pair.at_wall() ? dot(line.position, in_space(1.0, n)) : 0.0;
    if (old != nullptr) {
      ++lasting;
      touch.armed = old->armed;
      touch.anchor = old->anchor;
    } else {
      ++account.softened;
      touch.armed = pair.at_wall() ? 1 : 0;
      touch.anchor = along;
    }
    if (pair.at_wall() && touch.armed != 0 && std::fabs(along - touch.anchor) > settings_.well_width) {
      touch.armed = 0;
    } else if (pair.at_wall() && touch.armed == 0 && std::fabs(dot(velocity, in_space(1.0, n))) < settings_.slow) {
      touch.armed = 1;
      touch.anchor = along;
    }
    kept.list.push_back(touch);
  }
  std::sort(kept.list.begin(), kept.list.end(), before);
  account.hardened += static_cast<std::int64_t>(touches_.list.size()) - lasting;
  touches_ = std::move(kept);
}

}  // namespace repose::hybrid
