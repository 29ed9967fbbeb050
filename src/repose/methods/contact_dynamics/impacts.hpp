// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/archive.hpp"
#include "repose/methods/contact_dynamics/gather.hpp"
#include "repose/methods/contact_dynamics/restitution.hpp"

#include <cstdint>
#include <vector>

namespace repose::contact_dynamics {

/// The times of a step [T].
struct StepTimes {
  double lag = 0.0;   ///< by which the velocities before the step are behind the positions
  double step = 0.0;  ///< the positions advance by this time, the velocities to half of it after the positions

  double kick() const { return lag + 0.5 * step; }
};

/// The impacts of a step, apart from its lasting contacts. A body flies freely until its first impact; there velocities
/// jump without the impulse of gravity (`solve_impact`); then the rest of the impulse of gravity acts. All contacts
/// take part, so that a shock spreads. So a bounce does not depend on where in the step it happens.
template <int D>
class Impacts {
 public:
  explicit Impacts(const SolverSettings& settings) : solver_(settings) {}

  /// Lets the impacts act on the free velocities of `problem`, whose contacts hold no biases of restitution. `before`
  /// holds the velocities of all bodies before the step.
  ImpactReport act(const std::vector<Body<D>>& before, const StepTimes& times, const Collisions& collisions,
                   Problem<D>& problem);

  /// The impulses of the impacts of this step, one for each contact; empty without impacts.
  const std::vector<Impulse<D>>& impulses() const { return impulses_; }

  /// Displacements [L] to add to velocity times step: a body turns where it touches, not where it was at the start of
  /// the step. One for each body; empty without impacts. `bodies` hold the velocities.
  const std::vector<Vec<D>>& displacements(const StepTimes& times, const Problem<D>& problem,
                                           const std::vector<Body<D>>& bodies);

  void exchange(Archive& archive) { archive.array("impacts/impulses", impulses_); }

 private:
  void find_times(const std::vector<Body<D>>& before, const StepTimes& times, const Problem<D>& problem);

  Solver<D> solver_;
  std::vector<Closing> closing_;
  std::vector<double> closing_times_;  // [T] after the start of the step
  std::vector<double> flown_;          // [T] by which gravity acts on each body before its impact, from its velocity
  std::vector<Vec<D>> acceleration_;   // [L/T^2] of the free bodies
  std::vector<char> late_;             // bodies that rebound in the second half of the step
  std::vector<Impulse<D>> impulses_;
  std::vector<Vec<D>> displacements_;
};

}  // namespace repose::contact_dynamics
