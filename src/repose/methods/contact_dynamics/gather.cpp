// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/gather.hpp"

#include "repose/boundaries/wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace repose::contact_dynamics {

namespace {

/// Overlap over roll radius that is not corrected. A packing at rest has more contacts than its grains have degrees of
/// freedom. If every overlap of rounding size were corrected, no impulses could satisfy all contacts, and the solver
/// would drift.
constexpr double settled_overlap = 1e-3;

/// Pairs that approach at less than this fraction of gravity times the time step are at rest or settle: no impact.
constexpr double slowest_impact = 0.02;

/// The geometry of two bodies close to each other.
template <int D>
struct Approach {
  Vec<D> normal{};
  double gap = 0.0;     ///< [L]
  double radius = 0.0;  ///< [L] roll radius
};

template <int D>
class Gathering {
 public:
  Gathering(const GatherInput<D>& input, const Grains<D>& grains, const std::vector<ContactLine<D>>& before,
            Problem<D>& problem, Collisions& collisions)
      : input_(input),
        grains_(grains),
        old_(before.begin()),
        old_end_(before.end()),
        problem_(problem),
        collisions_(collisions) {
    const double dt = input.settings.time_step;
    fall_ = margin_of_fall * magnitude(input.settings.gravity) * dt * dt;
    slow_ = slowest_impact * magnitude(input.settings.gravity) * dt;
    for (std::uint32_t w = 0; w < input.walls.size(); ++w) all_walls_.push_back(w);
  }

  void grain(std::uint32_t i, std::uint32_t j) {
    const auto& a = grains_.line[i];
    const auto& b = grains_.line[j];
    const Vec<D> d = separation(a.position, b.position, input_.settings.box);
    const double radii = a.radius + b.radius;
    const double distance2 = squared(d);
    // Most listed pairs are far apart: this avoids the root for them.
    const double widest = radii + 0.5 * margin_of_radius * radii + fall_ + relative_displacement(i, j);
    if (distance2 >= widest * widest) return;
    const double distance = std::sqrt(distance2);
    const Approach<D> approach{d * (1.0 / distance), distance - radii, 2.0 * a.radius * b.radius / radii};
    if (!meets(approach, i, problem_.free[j].velocity)) return;
    auto line = begin_line(approach, i, j);
    line.lever = distance / radii;
    line.first_turn = approach.radius / a.radius;
    finish(line, approach, input_.laws.of(grains_.material[i], grains_.material[j]), as_body(b));
  }

  void walls(std::uint32_t i) {
    const auto& a = grains_.line[i];
    touching_.clear();
    for (const auto w : kicked_far(i) ? std::span<const std::uint32_t>(all_walls_) : input_.near_walls.of(i)) {
      const auto& wall = input_.settings.walls[w];
      const auto& now = input_.walls[w];
      if (!now.present) continue;
      const auto from_point = from_wall(wall, now, a.position, input_.settings.box);
      const auto place = above(wall, now, from_point);
      const WallTouch<D> touch{w, w, from_point, place};
      const auto surface = problem_.free[body_of_wall(w)].velocity + surface_velocity(now, touch);
      if (meets(approach_of_wall(a, wall, place), i, surface)) touching_.add(w, w, from_point, place);
    }
    touching_.join(input_.settings.walls, input_.walls, a.radius);
    for (const auto& touch : touching_.all()) {
      if (!touching_.acts(touch)) continue;
      const auto& wall = input_.settings.walls[touch.wall];
      auto law = input_.laws.of(grains_.material[i], wall.material);
      if (wall.smooth) law.friction = law.dynamic_friction = law.rolling_friction = law.twisting_friction = 0.0;
      const auto approach = approach_of_wall(a, wall, touch.place);
      auto line = begin_line(approach, i, body_of_wall(touch.wall));
      const auto& now = input_.walls[touch.wall];
      if (now.turns()) line.second = add_surface(problem_, touch.wall, behind(now, touch, a.radius));
      finish(line, approach, law, Body<D>(problem_.free[line.second]));
    }
  }

 private:
  static Approach<D> approach_of_wall(const Grain<D>& grain, const Wall<D>& wall, const AboveWall<D>& place) {
    return {place.normal, place.height - (wall.smooth ? 2.0 : 1.0) * grain.radius, grain.radius};
  }

  std::uint32_t body_of_wall(std::uint32_t wall) const { return static_cast<std::uint32_t>(grains_.size()) + wall; }

  /// Whether forces take a grain farther in this step than the lists foresee.
  bool kicked_far(std::uint32_t i) const {
    const Vec<D> kick = problem_.free[i].velocity - grains_.line[i].velocity;
    return magnitude(kick) * input_.settings.time_step > fall_;
  }

  double relative_displacement(std::uint32_t i, std::uint32_t j) const {
    const Vec<D> relative = problem_.free[i].velocity - problem_.free[j].velocity;
    return magnitude(relative) * input_.settings.time_step;
  }

  static Body<D> as_body(const Grain<D>& grain) { return {grain.velocity, grain.rim_velocity, grain.inverse_mass}; }

  /// The body of a grain of this radius that would touch a wall from behind and turn with it.
  static Body<D> behind(const WallNow<D>& now, const WallTouch<D>& touch, double radius) {
    const Spin<D> rim = now.spin * radius;
    const Vec<D> turning = in_space(spin_cross(rim, touch.place.normal), touch.place.normal);
    return {now.velocity + surface_velocity(now, touch) - turning, rim, 0.0};
  }

  double closing_distance(const Approach<D>& approach, std::uint32_t i, const Vec<D>& other) const {
    const Vec<D> relative = other - problem_.free[i].velocity;
    return dot(relative, approach.normal) * input_.settings.time_step;
  }

  /// `other` [L/T] is the velocity of the other body.
  bool meets(const Approach<D>& approach, std::uint32_t i, const Vec<D>& other) const {
    const double margin = std::max(margin_of_radius * approach.radius, fall_);
    return approach.gap - std::max(0.0, closing_distance(approach, i, other)) < margin;
  }

  ContactLine<D> begin_line(const Approach<D>& approach, std::uint32_t i, std::uint32_t j) {
    ContactLine<D> line;
    line.normal = approach.normal;
    line.first = i;
    line.second = j;
    while (old_ != old_end_ && std::tie(old_->first, old_->second) < std::tie(i, j)) ++old_;
    if (old_ != old_end_ && old_->first == i && old_->second == j) line.impulse = turned_impulse(*old_, line.normal);
    return line;
  }

  /// The impulse of the step before, turned with its contact: the tangential and rolling parts stay in the tangent
  /// plane and the part of twisting along the normal.
  static Impulse<D> turned_impulse(const ContactLine<D>& old, const Vec<D>& normal) {
    auto impulse = old.impulse;
    if constexpr (D == 3) {
      const double twist = dot(impulse.roll, old.normal);
      impulse.tangent = turned(impulse.tangent, normal);
      impulse.roll = turned(Vec<3>(impulse.roll - old.normal * twist), normal) + normal * twist;
    }
    return impulse;
  }

  /// Completes a line and adds it to the problem. `other` has the velocities of the second body before the step.
  void finish(ContactLine<D>& line, const Approach<D>& approach, const ImpulseLaw& law, const Body<D>& other) {
    const auto first = as_body(grains_.line[line.first]);
    if (line.second < problem_.first_wall) {
      set_masses(line, first.inverse_mass, other.inverse_mass);
    } else {
      const auto& direction = problem_.wall_direction[line.second - problem_.first_wall];
      set_wall_masses(line, first.inverse_mass, other.inverse_mass, direction);
    }
    line.friction = friction_at(law, magnitude(slip_velocity(line, first, other)));
    line.rolling_friction = law.rolling_friction;
    problem_.rolling |= law.rolling_friction > 0.0;
    if constexpr (D == 3) {
      line.twisting.friction = law.twisting_friction;
      problem_.rolling |= law.twisting_friction > 0.0;
    }
    line.normal_bias = normal_bias(approach);
    const auto place = static_cast<std::uint32_t>(problem_.contacts.size());
    const bool rebounds = law.restitution > 0.0 || law.tangential_restitution != 0.0;
    const double opening = opening_velocity(line, first, other);
    if (rebounds && opening < -slow_ &&
        closing_distance(approach, line.first, problem_.free[line.second].velocity) >= approach.gap) {
      collisions_.closing.push_back({place, approach.gap, law.restitution, law.tangential_restitution});
    } else if (rebounds && opening > 0.0) {
      collisions_.opening.push_back({place, law.restitution});
    }
    problem_.contacts.push_back(line);
  }

  /// Signorini's condition on velocities: a gap may just close within the step. An overlap is corrected gradually.
  double normal_bias(const Approach<D>& approach) const {
    const auto& settings = input_.settings;
    if (approach.gap > 0.0) return approach.gap / settings.time_step;
    const double overlap = std::max(0.0, -approach.gap - settled_overlap * approach.radius);
    return -settings.overlap_recovery * std::min(overlap, margin_of_radius * approach.radius) / settings.time_step;
  }

  const GatherInput<D>& input_;
  const Grains<D>& grains_;
  typename std::vector<ContactLine<D>>::const_iterator old_;
  typename std::vector<ContactLine<D>>::const_iterator old_end_;
  Problem<D>& problem_;
  Collisions& collisions_;
  std::vector<std::uint32_t> all_walls_;
  WallContacts<D> touching_;  // of the grain at hand
  double fall_ = 0.0;         // [L]
  double slow_ = 0.0;         // [L/T]
};

}  // namespace

template <int D>
void gather(const GatherInput<D>& input, const Grains<D>& grains, const PairList<D>& pairs,
            const std::vector<ContactLine<D>>& before, Problem<D>& problem, Collisions& collisions) {
  problem.contacts.clear();
  problem.rolling = false;
  collisions.closing.clear();
  collisions.opening.clear();
  Gathering<D> gathering(input, grains, before, problem, collisions);
  for (std::uint32_t i = 0; i < pairs.rows(); ++i) {
    for (auto k = pairs.row_start[i]; k < pairs.row_start[i + 1]; ++k) gathering.grain(i, pairs.partner[k]);
    if (grains.line[i].fixed() || input.walls.empty()) continue;
    gathering.walls(i);
  }
}

template <int D>
void renumber(const std::vector<std::uint32_t>& order, std::size_t grains_before,
              std::vector<ContactLine<D>>& contacts) {
  constexpr auto gone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(grains_before, gone);
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    if (order[k] < grains_before) place[order[k]] = k;
  }
  const auto moved = [&](std::uint32_t body) {
    if (body < grains_before) return place[body];
    return static_cast<std::uint32_t>(body - grains_before + order.size());
  };
  for (auto& c : contacts) {
    c.first = moved(c.first);
    c.second = moved(c.second);
    if (c.first < c.second) continue;
    // Normal and tangent reverse together, so only vectors in space and quantities of one side change.
    std::swap(c.first, c.second);
    c.normal = -c.normal;
    c.impulse.tangent = swapped(c.impulse.tangent);
    c.impulse.roll = -c.impulse.roll;
    c.first_turn = 2.0 - c.first_turn;
  }
  std::erase_if(contacts, [&](const auto& c) { return c.second == gone || c.first == gone; });
  std::vector<std::uint32_t> sorted(contacts.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::sort(sorted.begin(), sorted.end(), [&](auto a, auto b) {
    return std::tie(contacts[a].first, contacts[a].second) < std::tie(contacts[b].first, contacts[b].second);
  });
  std::vector<ContactLine<D>> in_order;
  in_order.reserve(contacts.size());
  for (const auto k : sorted) in_order.push_back(contacts[k]);
  contacts.swap(in_order);
}

template void gather(const GatherInput<2>&, const Grains<2>&, const PairList<2>&, const std::vector<ContactLine<2>>&,
                     Problem<2>&, Collisions&);
template void gather(const GatherInput<3>&, const Grains<3>&, const PairList<3>&, const std::vector<ContactLine<3>>&,
                     Problem<3>&, Collisions&);
template void renumber(const std::vector<std::uint32_t>&, std::size_t, std::vector<ContactLine<2>>&);
template void renumber(const std::vector<std::uint32_t>&, std::size_t, std::vector<ContactLine<3>>&);

}  // namespace repose::contact_dynamics
