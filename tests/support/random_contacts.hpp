// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

namespace repose::contact_dynamics {

/// Random contacts between bodies near each other in memory, as in a bed. Some bodies are fixed, and one of them, like
/// a floor, has many contacts.
inline Problem<2> random_problem(std::size_t bodies, std::size_t contacts, bool rolling, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  Problem<2> problem;
  problem.rolling = rolling;
  for (std::size_t k = 0; k < bodies; ++k) {
    Body<2> body;
    body.velocity = {{number(-1.0, 1.0), number(-1.0, 1.0)}};
    body.rim_velocity = number(-1.0, 1.0);
    body.inverse_mass = k == 0 || k % 7 == 3 ? 0.0 : number(0.5, 2.0);
    problem.free.push_back(body);
  }
  while (problem.contacts.size() < contacts) {
    ContactLine<2> c;
    const auto first = std::uniform_int_distribution<std::size_t>(1, bodies - 1)(random);
    const auto second = random() % 4 == 0 ? 0 : std::min(bodies - 1, first + 1 + random() % 6);
    const double mobility = problem.free[first].inverse_mass + problem.free[second].inverse_mass;
    if (first == second || !(mobility > 0.0)) continue;
    const double angle = number(0.0, 6.0);
    c.normal = {{std::cos(angle), std::sin(angle)}};
    c.first = static_cast<std::uint32_t>(first);
    c.second = static_cast<std::uint32_t>(second);
    c.normal_bias = number(-0.2, 0.2);
    c.tangent_bias = number(-0.1, 0.1);
    const double frictions[] = {0.0, 0.5, std::numeric_limits<double>::infinity()};
    c.friction = frictions[random() % 3];
    c.rolling_friction = frictions[random() % 3];
    c.lever = number(0.9, 1.1);
    c.first_turn = number(0.5, 1.5);
    if (random() % 2 == 0) c.impulse = {number(0.0, 1.0), number(-0.3, 0.3), rolling ? number(-0.3, 0.3) : 0.0};
    set_masses(c, problem.free[first].inverse_mass, problem.free[second].inverse_mass);
    problem.contacts.push_back(c);
  }
  problem.bodies = problem.free;
  return problem;
}

}  // namespace repose::contact_dynamics
