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

#include <cstdint>
#include <vector>

namespace repose {

/// What an advance did.
struct StepReport {
  long steps = 0;        ///< steps taken
  bool trouble = false;  ///< a grain became too fast to follow, or not a number: the state is not to be trusted
};

/// A constant outer force on one grain.
template <int D>
struct Load {
  std::int64_t grain = 0;  ///< id
  Vec<D> force{};          ///< [M L/T^2]
};

/// A way to move the grains, as the Simulation sees it.
template <int D>
class Method {
 public:
  virtual ~Method() = default;

  /// Takes up to `steps` steps; fewer only in trouble.
  virtual StepReport advance(Grains<D>& grains, long steps, Team& team) = 0;

  /// To be told when grains were added at the end of the arrays.
  virtual void grains_added(Grains<D>& grains) = 0;

  /// Brings what the method knows of the grains up to date now: grains that have left the box are dropped.
  virtual void refresh(Grains<D>& grains, Team& team) = 0;

  /// Contacts of the present state, ordered by ids.
  virtual Contacts<D> contacts(const Grains<D>& grains) const = 0;

  virtual double time_step() const = 0;

  /// The outer forces from now on; the list may only grow, and a load that ends becomes zero.
  virtual void set_loads(const std::vector<Load<D>>& loads) = 0;

  /// Gives contacts the displacements that they remember from elsewhere, as `contacts` reports them, pairs by ids. To
  /// be called at the start, after a refresh.
  virtual void set_histories(const Grains<D>& grains, const Contacts<D>& contacts) = 0;

  /// Where the walls are now.
  virtual const std::vector<WallState>& walls() const = 0;

  /// Impulse of the grains on each wall [M L/T] since this was last called.
  virtual std::vector<Vec<D>> taken_wall_impulses() = 0;

  /// What its solver did since this was last called; nothing of a method without one.
  virtual SolverAccount taken_solver_account() { return {}; }

  /// All that the method knows besides its settings, for a checkpoint.
  virtual void exchange(Archive& archive) = 0;

  /// To be told when grains and method have been restored: the next step is that which would have been the next.
  virtual void restored(const Grains<D>& grains, const Team& team) = 0;

  /// Grains that the method itself has put there, for one that forms a packing grain by grain.
  virtual std::int64_t made() const { return 0; }

  /// Whether there is nothing more for the method to do.
  virtual bool complete() const { return false; }

  /// Grains that one step moves, of so many that can move.
  virtual double grains_per_step(std::size_t moving) const { return static_cast<double>(moving); }

  /// The account of the energy half a step ago; empty unless the method keeps one.
  virtual Energy energy(const Grains<D>& grains) const = 0;
};

}  // namespace repose
