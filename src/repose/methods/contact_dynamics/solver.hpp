// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/methods/contact_dynamics/line_sweeps.hpp"
#include "repose/methods/contact_dynamics/pack_sweeps.hpp"
#include "repose/methods/contact_dynamics/search.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// Solves contact problems by the sweeps that suit them (see Search): many contacts eight at a time; few contacts one
/// by one in their own order, in which one sweep carries a change along a whole chain.
template <int D>
class Solver {
 public:
  explicit Solver(const SolverSettings& settings) : settings_(settings), one_by_one_(settings), packed_(settings) {}

  /// The result is the same for any size of the team.
  Solution solve(Problem<D>& problem, Team& team) {
    if constexpr (D == 2) {
      const bool many = problem.contacts.size() >= fewest_packed;
      if (settings_.packed && many && !problem.pistons) return packed_.solve(problem, team);
    }
    return one_by_one_.solve(problem, team);
  }

  /// Solves on this thread.
  Solution solve(Problem<D>& problem) {
    Team alone(1);
    return solve(problem, alone);
  }

 private:
  static constexpr std::size_t fewest_packed = 128;

  SolverSettings settings_;
  Search<D, LineSweeps<D>> one_by_one_;
  Search<2, PackSweeps> packed_;
};

}  // namespace repose::contact_dynamics
