// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/laws/impulse_law.hpp"
#include "repose/methods/contact_dynamics/impacts.hpp"
#include "repose/methods/contact_dynamics/settings.hpp"
#include "repose/methods/contact_dynamics/solver.hpp"
#include "repose/methods/method.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace repose {

/// Contact dynamics: rigid grains whose contacts obey Signorini's condition, Coulomb's law and the friction of rolling,
/// and of spheres twisting, at the end of each step, by implicit time stepping. Velocities are those half a step before
/// the positions.
/// Source: Moreau (1988), Jean (1999); Bratberg (2003), 4.6-4.8, as corrected in docs/physics/contact_dynamics.md.
template <int D>
class ContactDynamics final : public Method<D> {
 public:
  ContactDynamics(ImpulseLaws laws, ContactDynamicsSettings<D> settings);

  TimeSteps time_steps() const override { return {settings_.time_step, true}; }
  double time() const override { return time_steps().after(step_); }
  StepReport advance(Grains<D>& grains, double until, Team& team) override;
  void grains_added(Grains<D>& grains) override;
  void refresh(Grains<D>& grains, Team& team) override;
  Contacts<D> contacts(const Grains<D>& grains) const override;
  void set_loads(const std::vector<Load<D>>& loads) override { loads_ = loads; }
  /// Contacts start from the impulses that go with these forces.
  void set_slip_displacements(const Grains<D>& grains, const Contacts<D>& contacts) override;
  const std::vector<WallState>& walls() const override { return walls_; }
  std::vector<Crossings> wall_crossings(const Grains<D>& grains) const override {
    return crossings_.until(grains, settings_.walls, walls_now(), settings_.box, time());
  }
  std::vector<Vec<D>> take_wall_impulses() override;
  SolverAccount take_solver_account() override { return std::exchange(account_, {}); }
  void exchange(Archive& archive) override;
  const contact_dynamics::Problem<D>* problem_at(double time, Grains<D>& grains, Team& team) override;

  /// What the solver did since `take_solver_account`.
  const SolverAccount& account() const { return account_; }
  /// The solution of the last step.
  const contact_dynamics::Solution& solution() const { return solution_; }
  /// The problem of the last step, with the impulses.
  const contact_dynamics::Problem<D>& problem() const { return problem_; }

 private:
  bool step(Grains<D>& grains, Team& team);
  void pose(Grains<D>& grains, Team& team);
  void refresh_pairs(Grains<D>& grains, Team& team);
  void build_pairs(Grains<D>& grains, Team& team);
  void refresh_near_walls(const Grains<D>& grains, const std::vector<WallNow<D>>& walls);
  void set_free_velocities(const Grains<D>& grains);
  void limit_speeds();
  void set_free_wall(std::size_t w, double kick);
  void find_contacts(const Grains<D>& grains);
  void forget_impulses(const Grains<D>& grains);
  void collide(const Grains<D>& grains);
  void solve(Team& team);
  bool move(Grains<D>& grains);
  contact_dynamics::StepTimes times() const;
  contact_dynamics::Impulse<D> impulse_of(std::size_t contact) const;
  void add_reactions(Grains<D>& grains);
  std::vector<WallNow<D>> walls_now() const;

  ImpulseLaws laws_;
  ContactDynamicsSettings<D> settings_;
  PairList<D> pairs_;
  contact_dynamics::NearWalls<D> near_walls_;
  contact_dynamics::Problem<D> problem_;
  contact_dynamics::Solver<D> solver_;
  contact_dynamics::Impacts<D> impacts_;
  contact_dynamics::Collisions collisions_;
  std::vector<contact_dynamics::ContactLine<D>> before_;  // contacts of the previous step, whose impulses are the start
  std::size_t known_ = 0;                                 // number of grains when bodies were last numbered
  long step_ = 0;
  bool follows_ = false;  // the first step follows a step of a former run
  double turned_ = 0.0;   // [L] the largest displacement of the last step beyond velocity times step
  std::vector<WallState> walls_;
  std::vector<WallState> walls_at_build_;
  WallCrossings<D> crossings_;
  std::vector<Vec<D>> wall_impulses_;
  std::vector<Load<D>> loads_;
  std::vector<contact_dynamics::Body<D>> advancing_;  // velocities by which positions advance in the step
  contact_dynamics::Solution solution_;
  bool impacts_converged_ = true;
  SolverAccount account_;
};

template <int D>
std::unique_ptr<Method<D>> make_contact_dynamics(const ImpulseLaws& laws, const ContactDynamicsSettings<D>& settings) {
  return std::make_unique<ContactDynamics<D>>(laws, settings);
}

}  // namespace repose
