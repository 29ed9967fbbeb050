// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/step.hpp"

#include <algorithm>

namespace repose::hybrid {

SoftBody body_of(const Surroundings& around, const Grains<2>& grains, std::uint32_t grain, double entry,
                 double length) {
  constexpr double shortest = 1e-6;  // of the step: a grain that enters at its very end is there for this long
  const auto& line = grains.line[grain];
  SoftBody body;
  body.grain = grain;
  body.mass = line.mass;
  body.radius = line.radius;
  body.entry = std::min(entry, (1.0 - shortest) * length);
  body.duration = length - body.entry;
  body.start = line.position;
  body.velocity = line.velocity;
  body.rim_velocity = line.rim_velocity;
  body.pinned = around.pinned[grain] != 0;
  if (body.pinned) body.velocity[0] = 0.0;
  body.moved = body.velocity * body.duration;
  body.rolled = body.rim_velocity * body.duration;
  return body;
}

void gather_bodies(const Surroundings& around, const Grains<2>& grains, const Touches& touches, double length,
                   SoftSystem& system) {
  std::vector<std::uint8_t> soft(grains.size());
  const auto mark = [&](std::uint32_t grain) { soft[grain] = grains.line[grain].fixed() ? 0 : 1; };
  for (const auto& touch : touches.list) {
    mark(touch.grain);
    if (touch.partner >= 0) mark(static_cast<std::uint32_t>(touch.partner));
  }
  for (std::uint32_t k = 0; k < grains.size(); ++k) {
    if (soft[k] != 0) system.bodies.push_back(body_of(around, grains, k, 0.0, length));
  }
}

std::vector<std::uint32_t> bodies_of(const Grains<2>& grains, const SoftSystem& system) {
  std::vector<std::uint32_t> body(grains.size(), nobody);
  for (std::uint32_t k = 0; k < system.bodies.size(); ++k) body[system.bodies[k].grain] = k;
  return body;
}

void gather_pairs(const Surroundings& around, const Grains<2>& grains, const Touches& touches,
                  const std::vector<std::uint32_t>& body, SoftSystem& system) {
  const auto& settings = around.settings;
  system.pairs.clear();
  for (std::uint32_t k = 0; k < system.bodies.size(); ++k) {
    const auto& first = system.bodies[k];
    for (const auto other : around.near.of(first.grain)) {
      const auto& line = grains.line[other];
      const bool is_body = body[other] != nobody;
      if (is_body ? other < first.grain : !line.fixed()) continue;
      SoftPair pair;
      pair.first = k;
      pair.second = body[other];
      pair.partner = other;
      const Vec<2> place = is_body ? system.bodies[body[other]].start : line.position;
      pair.apart = separation(first.start, place, settings.box);
      pair.reach = first.radius + line.radius;
      pair.friction = around.laws.of(grains.material[first.grain], grains.material[other]).rolling_friction;
      system.pairs.push_back(pair);
    }
    for (std::uint32_t w = 0; w < settings.walls.size(); ++w) {
      const auto& wall = settings.walls[w];
      SoftPair pair;
      pair.first = k;
      pair.partner = -1 - static_cast<std::int64_t>(w);
      pair.apart = first.start - wall.point;
      pair.normal = wall.normal;
      pair.reach = wall_reach(wall, first.radius);
      if (dot(pair.apart, wall.normal) > pair.reach + settings.skin + 2.0 * magnitude(first.moved)) continue;
      if (!wall.smooth) {
        pair.friction = around.laws.of(grains.material[first.grain], wall.material).rolling_friction;
        const auto* touch = touches.find(first.grain, pair.partner);
        if (touch != nullptr && touch->armed != 0 && !first.pinned) {
          pair.well = settings.static_friction / settings.well_width;
          pair.off_anchor = dot(first.start, wall_tangent(wall)) - touch->anchor;
        }
      }
      system.pairs.push_back(pair);
    }
  }
  for (auto& pair : system.pairs) system.time_pair(pair);
}

SoftSystem make_system(const HybridSettings& settings) {
  SoftSystem system;
  system.spring = settings.spring;
  system.slip_drag = settings.slip_drag;
  system.gravity = settings.gravity;
  system.weight = settings.weight;
  return system;
}

Solved solve(const HybridSettings& settings, DirectSolver& solver, SoftSystem& system, double tolerance,
             bool definite) {
  if (settings.by_sweeps) return solve_by_sweeps(system, tolerance, settings.relaxation);
  return solver.solve(system, tolerance, definite);
}

}  // namespace repose::hybrid
