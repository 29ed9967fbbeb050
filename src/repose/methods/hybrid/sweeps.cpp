// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/hybrid/soft_solver.hpp"

#include <cmath>

namespace repose::hybrid {

namespace {

constexpr long most_soft_sweeps = 200000;
constexpr long between_residuals = 10;

/// The pairs of each body.
struct PairsOfBodies {
  std::vector<std::uint32_t> start, entry;

  explicit PairsOfBodies(const SoftSystem& system) : start(system.bodies.size() + 1) {
    const auto count = [&](std::uint32_t body) {
      if (body != nobody) ++start[body + 1];
    };
    for (const auto& pair : system.pairs) {
      count(pair.first);
      count(pair.second);
    }
    for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
    entry.resize(start.back());
    auto next = start;
    for (std::uint32_t p = 0; p < system.pairs.size(); ++p) {
      entry[next[system.pairs[p].first]++] = p;
      if (system.pairs[p].second != nobody) entry[next[system.pairs[p].second]++] = p;
    }
  }
};

/// One step of Newton's method for one body among others that stay.
void relax_body(SoftSystem& system, const PairsOfBodies& of, std::uint32_t k, bool rolling, double relaxation) {
  auto& body = system.bodies[k];
  Vec<2> force = system.own_unbalanced(body);
  const double inertia = 2.0 * body.mass / (body.duration * system.step);
  Symmetric slope{inertia, 0.0, inertia};
  double turn = rolling ? system.own_turn(body) : 0.0;
  double slope_of_turn = 0.5 * inertia;
  for (auto e = of.start[k]; e < of.start[k + 1]; ++e) {
    auto& pair = system.pairs[of.entry[e]];
    const bool is_first = pair.first == k;
    force += system.act(pair) * (is_first ? -1.0 : 1.0);
    turn += system.turning(pair);
    const auto slopes = system.slopes(pair);
    const auto& own = is_first ? slopes.first : slopes.second;
    slope.xx += own.xx;
    slope.xy += own.xy;
    slope.yy += own.yy;
    slope_of_turn += is_first ? slopes.drag_first : slopes.drag_second;
  }
  if (body.pinned) {
    body.moved[1] -= relaxation * force[1] / slope.yy;
  } else {
    const double determinant = slope.xx * slope.yy - slope.xy * slope.xy;
    const Vec<2> step{{(slope.yy * force[0] - slope.xy * force[1]) / determinant,
                       (slope.xx * force[1] - slope.xy * force[0]) / determinant}};
    body.moved -= step * relaxation;
  }
  if (rolling) body.rolled -= relaxation * turn / slope_of_turn;
}

}  // namespace

Solved solve_by_sweeps(SoftSystem& system, double tolerance, double relaxation) {
  const PairsOfBodies of(system);
  const bool rolling = system.rolls();
  if (!rolling && !system.statics) {
    for (auto& body : system.bodies) body.rolled = body.rim_velocity * body.duration;
  }
  Solved solved;
  for (;;) {
    system.balance();
    const auto worst = system.worst();
    solved.residual = worst.residual;
    solved.worst = worst.body;
    solved.converged = worst.residual <= tolerance;
    if (solved.converged || !std::isfinite(worst.residual) || solved.iterations >= most_soft_sweeps) return solved;
    for (long sweep = 0; sweep < between_residuals; ++sweep) {
      for (std::uint32_t k = 0; k < system.bodies.size(); ++k) relax_body(system, of, k, rolling, relaxation);
    }
    solved.iterations += between_residuals;
  }
}

}  // namespace repose::hybrid
