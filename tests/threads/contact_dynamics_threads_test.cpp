// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/contact_dynamics/pack_groups.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"
#include "support/random_contacts.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <string>

// The solver has the same bits for any number of threads. The problem is large enough to be shared between them.

namespace repose::contact_dynamics {
namespace {

Problem<2> solved(Problem<2> problem, bool accelerated, int threads) {
  SolverSettings settings;
  settings.tolerance = 0.0;
  settings.most_sweeps = 25;
  settings.accelerated = accelerated;
  Team team(threads);
  Solver<2>(settings).solve(problem, team);
  return problem;
}

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(ContactDynamicsThreads, TheSolutionDoesNotDependOnTheirNumber) {
  constexpr std::size_t contacts = 20000;
  ASSERT_GT(parts_of(contacts), 4u);
  for (const bool rolling : {false, true}) {
    const auto problem = random_problem(12000, contacts, rolling, 3);
    for (const bool accelerated : {false, true}) {
      const auto expected = solved(problem, accelerated, 1);
      for (const int threads : {2, 3, 5}) {
        SCOPED_TRACE(std::to_string(threads) + " threads" + (accelerated ? ", accelerated" : ""));
        const auto found = solved(problem, accelerated, threads);
        std::size_t different = 0;
        for (std::size_t k = 0; k < contacts; ++k) {
          const auto &a = expected.contacts[k].impulse, &b = found.contacts[k].impulse;
          different += !same(a.normal, b.normal) || !same(a.tangent, b.tangent) || !same(a.roll, b.roll);
        }
        for (std::size_t k = 0; k < expected.bodies.size(); ++k) {
          const auto &a = expected.bodies[k], &b = found.bodies[k];
          different += !same(a.velocity[0], b.velocity[0]) || !same(a.velocity[1], b.velocity[1]);
          different += !same(a.rim_velocity, b.rim_velocity);
        }
        EXPECT_EQ(different, 0u);
      }
    }
  }
}

}  // namespace
}  // namespace repose::contact_dynamics
