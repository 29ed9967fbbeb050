// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"

namespace repose {

/// What the solver did in the whole run, and what a deposition was set to.
template <int D>
void add_solver_in(RegistryIn<D>& to) {
  const auto account = [](auto member) {
    return [=](const MeasuredIn<D>& run) { return solver_account(run.record.series).*member; };
  };
  const auto add = [&](MeasureIn<D> measure) { to.measures.push_back(std::move(measure)); };
  add(measure<D>(
      "solver", "", "over the whole run", [](const MeasuredIn<D>&) { return Object{}; }, Needs::solver));
  add(measure<D>("solver.steps", "", "time steps", account(&SolverAccount::steps)));
  add(measure<D>("solver.sweeps_per_step", "", "forward and backward sweeps",
                 [](const MeasuredIn<D>& run) -> std::optional<double> {
                   const auto all = solver_account(run.record.series);
                   if (all.steps == 0) return std::nullopt;
                   return static_cast<double>(all.sweeps) / static_cast<double>(all.steps);
                 }));
  add(measure<D>("solver.contact_iterations", "", "contacts visited by sweeps, each way counted",
                 account(&SolverAccount::contact_iterations)));
  add(measure<D>("solver.unconverged", "", "steps that reached `method.most_sweeps`",
                 account(&SolverAccount::unconverged)));
  add(measure<D>("solver.impacts", "", "impacts of contacts with restitution", account(&SolverAccount::impacts)));
  add(measure<D>("solver.impacts_reduced", "",
                 "impacts whose restitution gave way, so that the kinetic energy does not rise",
                 account(&SolverAccount::reduced)));
  add(measure<D>("solver.restitution_kept", "",
                 "mean over impacts of the fraction of the asked restitution that was kept",
                 [](const MeasuredIn<D>& run) -> std::optional<double> {
                   const auto all = solver_account(run.record.series);
                   if (all.impacts == 0) return std::nullopt;
                   return 1.0 - all.restitution_lost / static_cast<double>(all.impacts);
                 }));
  add(measure<D>("solver.worst_residual", "g dt", "worst residual velocity of a contact",
                 account(&SolverAccount::worst_residual)));
  add(measure<D>("solver.tolerance", "g dt", "`method.tolerance` of the scene",
                 [](const MeasuredIn<D>& run) -> std::optional<double> {
                   const auto* solver = run.record.scene.method->solver();
                   if (solver == nullptr) return std::nullopt;
                   return solver->tolerance;
                 }));
  add(measure<D>("solver.creep_rate", "L/T", "median speed of the grains that touch something, at the last observation",
                 [](const MeasuredIn<D>& run) -> std::optional<double> {
                   if (run.record.series.empty()) return std::nullopt;
                   return run.record.series.back().creep_rate;
                 }));
  add(only_where<D>(
      [](const MeasuredIn<D>& run) { return has(run.record.scene, Needs::deposition); },
      measure<D>(
          "critical_angle", "deg", "`method.critical_angle` of the scene",
          [](const MeasuredIn<D>& run) { return run.record.scene.method->sticking_angle(); }, Needs::deposition)));
}

void add_solver(Registry& to) { add_solver_in(to); }
void add_solver(RegistryIn<3>& to) { add_solver_in(to); }

}  // namespace repose
