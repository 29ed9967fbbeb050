// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/energy.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/solver_account.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/time_steps.hpp"

#include <cstdint>
#include <vector>

namespace repose {

namespace contact_dynamics {
template <int D>
struct Problem;
}

/// What an advance did.
struct StepReport {
  double time = 0.0;     ///< [T] reached
  long steps = 0;        ///< steps taken, or events
  bool trouble = false;  ///< a grain became too fast to follow, or not a number: the state is not to be trusted
};

/// A constant outer force on one grain.
template <int D>
struct Load {
  std::int64_t grain = 0;  ///< id
  Vec<D> force{};          ///< [M L/T^2]
};

/// A method that moves the grains, as the Simulation sees it. What a method must do comes first; what only some do has
/// an empty default.
template <int D>
class Method {
 public:
  virtual ~Method() = default;

  /// How it divides time.
  virtual TimeSteps time_steps() const = 0;

  /// Of the present state [T].
  virtual double time() const = 0;

  /// Brings the grains to a time, or as near to it as equal steps come. Where steps vary it may return before that, so
  /// that no call takes much longer than a second. The state does not depend on the times between which calls divide a
  /// run.
  virtual StepReport advance(Grains<D>& grains, double until, Team& team) = 0;

  /// Called after grains were added at the end of the arrays.
  virtual void grains_added(Grains<D>& grains) = 0;

  /// Brings what the method knows of the grains up to date: grains that have left the box are dropped.
  virtual void refresh(Grains<D>& grains, Team& team) = 0;

  /// All that the method knows besides its settings, for a checkpoint.
  virtual void exchange(Archive& archive) = 0;

  /// Called after grains and method have been restored: the next step is that which would have been the next.
  virtual void restored(const Grains<D>& /*grains*/, const Team& /*team*/) {}

  /// Contacts of the present state, ordered by ids.
  virtual Contacts<D> contacts(const Grains<D>& /*grains*/) const { return {}; }

  /// Gives contacts the slip displacements that they have elsewhere, as `contacts` reports them, pairs by ids. Called
  /// at the start, after a refresh.
  virtual void set_histories(const Grains<D>& /*grains*/, const Contacts<D>& /*contacts*/) {}

  /// The outer forces from now on; the list may only grow, and a load that ends becomes zero.
  virtual void set_loads(const std::vector<Load<D>>& /*loads*/) {}

  /// Where the walls are now.
  virtual const std::vector<WallState>& walls() const {
    static const std::vector<WallState> none;
    return none;
  }

  /// Impulse of the grains on each wall [M L/T] since the last call.
  virtual std::vector<Vec<D>> take_wall_impulses() { return std::vector<Vec<D>>(walls().size()); }

  /// What the solver did since the last call; nothing for a method without a solver.
  virtual SolverAccount take_solver_account() { return {}; }

  /// The contact problem of the step that begins at a time [T], which is that of the grains, unsolved: contacts start
  /// from what `set_histories` gave them. Null for a method that poses none.
  virtual const contact_dynamics::Problem<D>* problem_at(double /*time*/, Grains<D>& /*grains*/, Team& /*team*/) {
    return nullptr;
  }

  /// The account of the energy half a step ago; empty unless the method keeps one.
  virtual Energy energy(const Grains<D>& /*grains*/) const { return {}; }

  /// Grains that the method itself has made, for one that forms a packing grain by grain.
  virtual std::int64_t made() const { return 0; }

  /// Whether there is nothing more for the method to do.
  virtual bool complete() const { return false; }

  /// Grains that one step moves, out of so many that can move.
  virtual double grains_per_step(std::size_t moving) const { return static_cast<double>(moving); }
};

}  // namespace repose
