// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/relax.hpp"

#include <algorithm>
#include <cmath>

namespace repose::hybrid {

namespace {

constexpr long most_descents = 3000;
constexpr double most_growth = 4.0;
constexpr double least_growth = 1.2;
constexpr double shrink = 3.0;
constexpr double loose = 1e-2;      // residual of a step of descent over the net forces that it begins with
constexpr double farthest = 0.05;   // radii that a grain may move in one step of descent
constexpr double shortest = 1e-8;   // [T of a time step]
constexpr double next_load = 4.0;   // over that of the stage before
constexpr double stage_end = 1e-3;  // net force of a stage over its gravity

/// The net force on a body at the end of a step of descent [weight]: what holds it back there.
double left_over(const SoftSystem& system, std::uint32_t& worst) {
  double largest = 0.0;
  for (const auto& body : system.bodies) {
    const double scale = 2.0 * body.mass / (body.duration * body.duration * system.weight);
    const double force = scale * std::max(body.pinned ? 0.0 : std::fabs(body.moved[0]), std::fabs(body.moved[1]));
    if (force < largest) continue;
    largest = force;
    worst = body.grain;
  }
  return largest;
}

/// The first stage of gravity: a small one where no spring is pressed yet, all of it else.
double first_load(SoftSystem& system) {
  constexpr double small = 1.0 / 64.0;
  system.balance();
  const double pressed = stage_end * small * system.weight;
  const bool any = std::any_of(system.pairs.begin(), system.pairs.end(),
                               [&](const auto& pair) { return pair.normal_force > pressed; });
  return any ? 1.0 : small;
}

/// Begins the next stage of gravity, where springs would yield by as much more.
void raise_load(Relaxation& progress, Grains<2>& grains) {
  const double load = std::min(1.0, next_load * progress.load);
  const double more = load / progress.load - 1.0;
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    const auto further = more * progress.displaced[k];
    grains.line[k].position += further;
    progress.displaced[k] += further;
  }
  progress.load = load;
}

/// The soft contacts at rest; returns whether a well broke.
bool touches_at_rest(const Surroundings& around, const Grains<2>& grains, const SoftSystem& system, Touches& touches) {
  Touches kept;
  bool broke = false;
  for (const auto& pair : system.pairs) {
    if (!(pair.normal_force > 0.0)) continue;
    const auto grain = system.bodies[pair.first].grain;
    Touch touch;
    touch.grain = grain;
    touch.partner = pair.partner;
    if (pair.partner >= 0 && pair.partner < grain) {
      touch.grain = static_cast<std::uint32_t>(pair.partner);
      touch.partner = grain;
    }
    touch.normal_force = pair.normal_force;
    touch.tangential_force = pair.well_force;
    if (pair.at_wall()) {
      const Vec<2> tangent = wall_tangent(around.settings.walls[wall_of(pair.partner)]);
      const double along = dot(grains.line[grain].position, tangent);
      const auto* old = touches.find(touch.grain, touch.partner);
      touch.armed = old != nullptr ? old->armed : 1;
      touch.anchor = old != nullptr ? old->anchor : along;
      if (touch.armed != 0 && std::fabs(along - touch.anchor) > around.settings.well_width) {
        touch.armed = 0;
        broke = !system.bodies[pair.first].pinned;
      }
      if (system.bodies[pair.first].pinned) {
        touch.tangential_force += system.unbalanced[pair.first][0] * tangent[0];
      }
    }
    kept.list.push_back(touch);
  }
  std::sort(kept.list.begin(), kept.list.end(), before);
  touches = std::move(kept);
  return broke;
}

}  // namespace

Relaxed relax(const Surroundings& around, Grains<2>& grains, Touches& touches, SoftSystem& system, DirectSolver& solver,
              Relaxation& progress, CollisionAccount& account) {
  const auto& settings = around.settings;
  system.begin(progress.length);
  system.statics = true;
  gather_bodies(around, grains, touches, progress.length, system);
  progress.displaced.resize(grains.size());
  const auto body = bodies_of(grains, system);
  for (; progress.steps < most_descents; ++progress.steps) {
    system.step = progress.length;
    for (auto& one : system.bodies) {
      one = body_of(around, grains, one.grain, 0.0, progress.length);
      one.moved = {};
      one.rolled = 0.0;
    }
    gather_pairs(around, grains, touches, body, system);
    if (progress.load == 0.0) progress.load = first_load(system);
    system.gravity = settings.gravity * progress.load;
    const double tolerance = std::max(settings.tolerance, loose * std::min(progress.load, progress.left));
    const auto solved = [&] {
      const Profile::Stage stage(around.profile, "solver");
      return solve(settings, solver, system, tolerance, true);
    }();
    account.iterations += solved.iterations;
    const bool near = std::all_of(system.bodies.begin(), system.bodies.end(),
                                  [&](const auto& one) { return magnitude(one.moved) <= farthest * one.radius; });
    if (!solved.converged || !near) {
      progress.length /= shrink;
      progress.growth = std::max(least_growth, std::sqrt(progress.growth));
      if (solved.worst != nobody) progress.worst = system.bodies[solved.worst].grain;
      if (progress.length < shortest * settings.time_step) return Relaxed::failed;
      continue;
    }
    for (const auto& one : system.bodies) {
      auto& line = grains.line[one.grain];
      line.position += one.moved;
      progress.displaced[one.grain] += one.moved;
      line.velocity = {};
      line.rim_velocity = 0.0;
    }
    const double left = left_over(system, progress.worst) + solved.residual;
    progress.left = left;
    const auto stays = [](std::uint32_t) { return 0.0; };
    if (progress.load < 1.0 && left <= std::max(settings.tolerance, stage_end * progress.load)) {
      raise_load(progress, grains);
      progress.left = 1.0;
      if (!around.near.holds(grains, stays)) return Relaxed::moved_far;
      continue;
    }
    if (left <= settings.tolerance) {
      const bool broke = touches_at_rest(around, grains, system, touches);
      account.worst_residual = std::max(account.worst_residual, left);
      if (!broke) return Relaxed::done;
      progress.length = settings.time_step;
      continue;
    }
    progress.length *= progress.growth;
    progress.growth = std::min(most_growth, 1.3 * progress.growth);
    if (!around.near.holds(grains, stays)) return Relaxed::moved_far;
  }
  return Relaxed::failed;
}

}  // namespace repose::hybrid
