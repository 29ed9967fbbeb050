// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/first_touch.hpp"
#include "repose/methods/hybrid/step.hpp"

#include <cmath>

namespace repose::hybrid {

namespace {

/// A pair that collides more often than this within a step has collapsed, and turns soft.
constexpr int most_meetings = 8;

}  // namespace

Step::Path Step::path(std::uint32_t grain, double time) const {
  const auto& line = grains_.line[grain];
  if (body_[grain] != nobody) {
    const auto& body = system_.bodies[body_[grain]];
    return {body.at(time), body.mean_velocity(), {}};
  }
  if (line.fixed()) return {line.position, {}, {}};
  const double t = time - since_[grain];
  const auto& g = settings_.gravity;
  return {line.position + line.velocity * t + g * (0.5 * t * t), line.velocity + g * t, g};
}

void Step::fly(std::uint32_t grain, double time) {
  const auto at = path(grain, time);
  grains_.line[grain].position = at.place;
  grains_.line[grain].velocity = at.velocity;
  since_[grain] = time;
}

const ImpulseLaw& Step::law(std::uint32_t grain, std::int64_t partner) const {
  const auto other =
      partner < 0 ? settings_.walls[wall_of(partner)].material : grains_.material[static_cast<std::uint32_t>(partner)];
  return around_.laws.of(grains_.material[grain], other);
}

void Step::find_event(std::uint32_t grain, std::int64_t partner, double now) {
  const auto own = path(grain, now);
  Event event{now, grain, partner, version_[grain], 0};
  if (partner < 0) {
    const auto& wall = settings_.walls[wall_of(partner)];
    const double gap = dot(own.place - wall.point, wall.normal) - wall_reach(wall, grains_.line[grain].radius);
    event.time += first_fall(gap, dot(own.velocity, wall.normal), 0.5 * dot(own.acceleration, wall.normal));
  } else {
    const auto other = static_cast<std::uint32_t>(partner);
    const auto its = path(other, now);
    event.partner_version = version_[other];
    event.time += first_touch(separation(own.place, its.place, settings_.box), own.velocity - its.velocity,
                              own.acceleration - its.acceleration,
                              grains_.line[grain].radius + grains_.line[other].radius, length_ - now);
  }
  if (event.time <= length_) events_.push(event);
}

void Step::find_events_of(std::uint32_t grain, double now) {
  for (std::size_t w = 0; w < settings_.walls.size(); ++w) find_event(grain, -1 - static_cast<std::int64_t>(w), now);
  for (const auto other : around_.near.of(grain)) find_event(grain, other, now);
}

void Step::find_events(double now) {
  events_ = {};
  for (std::uint32_t k = 0; k < grains_.size(); ++k) {
    if (!flies(k)) continue;
    for (std::size_t w = 0; w < settings_.walls.size(); ++w) find_event(k, -1 - static_cast<std::int64_t>(w), now);
    for (const auto other : around_.near.of(k)) {
      if (other > k || !flies(other)) find_event(k, other, now);
    }
  }
}

/// The velocities with which a grain collides. A body has those with which it enters the step.
Collider Step::collider(std::uint32_t grain) const {
  const auto& line = grains_.line[grain];
  if (body_[grain] == nobody) return {line.velocity, line.rim_velocity, line.inverse_mass};
  const auto& body = system_.bodies[body_[grain]];
  return {body.velocity, body.rim_velocity, line.inverse_mass};
}

void Step::give(std::uint32_t grain, const Collision& collision, const Vec<2>& n, double sign) {
  auto& line = grains_.line[grain];
  if (line.fixed()) {
    grains_.reaction[grain] += collision.impulse(n) * sign;
    return;
  }
  auto changed = collider(grain);
  receive(changed, collision, n, sign);
  if (body_[grain] == nobody) {
    line.velocity = changed.velocity;
    line.rim_velocity = changed.rim_velocity;
    return;
  }
  auto& body = system_.bodies[body_[grain]];
  body.velocity = changed.velocity;
  body.rim_velocity = changed.rim_velocity;
  if (body.pinned) body.velocity[0] = 0.0;
  outdated_ = true;
}

Vec<2> Step::acceleration(std::uint32_t grain) const {
  if (grains_.line[grain].fixed()) return {};
  if (body_[grain] == nobody) return settings_.gravity;
  const auto& body = system_.bodies[body_[grain]];
  return (body.end_velocity() - body.velocity) * (1.0 / body.duration);
}

bool Step::repeats(std::uint32_t grain, std::int64_t partner) {
  const auto low = partner >= 0 ? std::min<std::int64_t>(grain, partner) : grain;
  const auto high = partner >= 0 ? std::max<std::int64_t>(grain, partner) : partner;
  return ++met_[{static_cast<std::uint32_t>(low), high}] > most_meetings || account.hard > most_events_;
}

/// A meeting: a hard collision if the partners approach. A body takes its impulse at the start of the step, which is
/// then solved again: so no later solution changes the energy that the collision leaves. Returns whether the contact is
/// soft from now on: where gravity or the forces on its partners would close it again within the step, (22); where they
/// part slowly; where they have met too often; and where their paths approach though their velocities do not.
bool Step::meet(const Event& event) {
  const auto grain = event.grain;
  const bool at_wall = event.partner < 0;
  const auto other = at_wall ? nobody : static_cast<std::uint32_t>(event.partner);
  fly(grain, event.time);
  if (!at_wall && flies(other)) fly(other, event.time);
  const auto place = grains_.line[grain].position;
  Vec<2> n = at_wall ? settings_.walls[wall_of(event.partner)].normal
                     : separation(place, path(other, event.time).place, settings_.box);
  if (!at_wall) n *= 1.0 / magnitude(n);

  const auto first = collider(grain);
  const auto second = at_wall ? Collider{} : collider(other);
  const bool approach = normal_speed(first, second, n) < 0.0;
  double parting = 0.0;
  if (approach) {
    auto law = this->law(grain, event.partner);
    if (at_wall && settings_.walls[wall_of(event.partner)].smooth) law.friction = 0.0;
    const auto collision = collide(first, second, n, law);
    parting = -law.restitution * normal_speed(first, second, n);
    give(grain, collision, n, 1.0);
    if (at_wall) {
      wall_impulses[wall_of(event.partner)] -= collision.impulse(n);
    } else {
      give(other, collision, n, -1.0);
    }
    ++account.hard;
  }
  const Vec<2> relative = acceleration(grain) - (at_wall ? Vec<2>{} : acceleration(other));
  const double closing = -dot(relative, n);
  const bool again = closing > 0.0 && parting < closing * length_;
  const bool often = repeats(grain, event.partner);
  return !approach || again || parting < settings_.slow || often;
}

/// The contact is soft from this time on, and its grains are bodies.
void Step::soften(std::uint32_t grain, std::int64_t partner, double time) {
  auto touch = touch_between(grain, partner);
  if (partner < 0) {
    const auto& wall = settings_.walls[wall_of(partner)];
    touch.armed = 1;
    touch.anchor = dot(grains_.line[grain].position, wall_tangent(wall));
  }
  touches_.insert(touch);
  ++account.softened;
  if (flies(grain)) add_body(grain, time);
  if (partner >= 0 && flies(static_cast<std::uint32_t>(partner))) add_body(static_cast<std::uint32_t>(partner), time);
}

}  // namespace repose::hybrid
