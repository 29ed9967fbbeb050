// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/boundaries/wall.hpp"
#include "repose/core/archive.hpp"
#include "repose/core/collision_account.hpp"
#include "repose/core/contacts.hpp"
#include "repose/core/energy.hpp"
#include "repose/core/grains.hpp"
#include "repose/core/profile.hpp"
#include "repose/core/solver_account.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/time_steps.hpp"
#include "repose/methods/wall_crossings.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

namespace contact_dynamics {
template <int D>
struct Problem;
}

/// Result of an advance.
struct StepReport {
  double time = 0.0;     ///< [T] reached
  long steps = 0;        ///< steps taken, or events
  bool trouble = false;  ///< a grain became too fast to follow, or not a number: do not use the state
};

/// A constant outer force on one grain.
template <int D>
struct Load {
  std::int64_t grain = 0;  ///< id
  Vec<D> force{};          ///< [M L/T^2]
};

/// A method that moves the grains, as the Simulation sees it. The functions that every method must have come first; the
/// others have an empty default.
template <int D>
class Method {
 public:
  virtual ~Method() = default;

  /// How the method divides time into steps.
  virtual TimeSteps time_steps() const = 0;

  /// Time of the present state [T].
  virtual double time() const = 0;

  /// Brings the grains to a time, or as near to it as equal steps come. Where steps vary it may return earlier, so that
  /// no call takes much longer than a second. The state does not depend on how calls divide a run.
  virtual StepReport advance(Grains<D>& grains, double until, Team& team) = 0;

  /// The Simulation calls this after it has added grains at the end of the arrays.
  virtual void grains_added(Grains<D>& grains) = 0;

  /// Brings what the method stores about the grains up to date, and drops grains that have left the box.
  virtual void refresh(Grains<D>& grains, Team& team) = 0;

  /// Writes or reads everything that the method stores besides its settings, for a checkpoint.
  virtual void exchange(Archive& archive) = 0;

  /// The Simulation calls this after it has restored grains and method from a checkpoint. The next step must be the
  /// one that would have followed without the checkpoint.
  virtual void restored(const Grains<D>& /*grains*/, const Team& /*team*/) {}

  /// Contacts of the present state, ordered by ids.
  virtual Contacts<D> contacts(const Grains<D>& /*grains*/) const { return {}; }

  /// For each grain what it came to rest on, where all contacts follow from that; else null.
  virtual const std::vector<SupportPair>* supports() const { return nullptr; }

  /// Sets the slip displacements of contacts to those of another run, as its `contacts` reported them; pairs are found
  /// by ids. The Simulation calls this at the start, after a refresh.
  virtual void set_slip_displacements(const Grains<D>& /*grains*/, const Contacts<D>& /*contacts*/) {}

  /// Sets the outer forces from now on. The list may only grow; a load that ends becomes zero.
  virtual void set_loads(const std::vector<Load<D>>& /*loads*/) {}

  /// Where the walls are now.
  virtual const std::vector<WallState>& walls() const {
    static const std::vector<WallState> none;
    return none;
  }

  /// The grains that have gone through each wall of finite length.
  virtual std::vector<Crossings> wall_crossings(const Grains<D>& /*grains*/) const {
    return std::vector<Crossings>(walls().size());
  }

  /// Impulse of the grains on each wall [M L/T] since the last call, which this call resets.
  virtual std::vector<Vec<D>> take_wall_impulses() { return std::vector<Vec<D>>(walls().size()); }

  /// Work of the solver since the last call, which this call resets; empty for a method without a solver.
  virtual SolverAccount take_solver_account() { return {}; }

  /// Collisions and switches since the last call, which this call resets; empty for a method that does not count them.
  virtual CollisionAccount take_collision_account() { return {}; }

  /// After trouble: what the method knows of it that places and velocities do not show; else empty.
  virtual std::string trouble(const Grains<D>& /*grains*/) const { return {}; }

  /// The contact problem of the step that begins at a time [T], not yet solved. The time is that of the grains, and
  /// contacts start from the slip displacements of `set_slip_displacements`. Null for a method that poses no contact
  /// problem.
  virtual const contact_dynamics::Problem<D>* problem_at(double /*time*/, Grains<D>& /*grains*/, Team& /*team*/) {
    return nullptr;
  }

  /// The energies half a step ago; empty unless the method keeps an account of them.
  virtual Energy energy(const Grains<D>& /*grains*/) const { return {}; }

  /// Number of grains that the method itself has added, for a method that forms a packing grain by grain.
  virtual std::int64_t made() const { return 0; }

  /// Whether the method has nothing more to do.
  virtual bool complete() const { return false; }

  /// Number of grains that one step moves, when `moving` grains can move.
  virtual double grains_per_step(std::size_t moving) const { return static_cast<double>(moving); }

  /// Where the method counts the time of its stages from now on; null for nowhere.
  void set_profile(Profile* profile) { profile_ = profile; }

 protected:
  /// Everything that takes time in an advance belongs to a stage. No stage lies in a loop over grains.
  [[nodiscard]] Profile::Stage in_stage(std::string_view name) const { return {profile_, name}; }
  Profile* profile() const { return profile_; }

 private:
  Profile* profile_ = nullptr;
};

}  // namespace repose
