// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/version.hpp"
#include "repose/results/registry.hpp"
#include "repose/results/warnings.hpp"

namespace repose {

namespace {

/// A number of the last observation.
auto last(double SeriesRow::*member) {
  return [=](const auto& run) -> std::optional<double> {
    if (run.record.series.empty()) return std::nullopt;
    return run.record.series.back().*member;
  };
}

/// Contacts that count: none where geometry alone should give them and does not.
std::optional<std::size_t> contacts(const MeasuredIn<2>& run) {
  if (!has(run.record.scene, Needs::forces) && !run.results.packing) return std::nullopt;
  return run.results.network.contacts;
}
std::optional<std::size_t> contacts(const MeasuredIn<3>& run) {
  if (!has(run.record.scene, Needs::forces)) return std::nullopt;
  return run.results.network.contacts;
}

std::optional<double> grain_steps_per_second(const RunFacts& facts) {
  if (!(facts.wall_seconds > 0.0)) return std::nullopt;
  return facts.grain_steps / facts.wall_seconds;
}

}  // namespace

/// What was run and how it went.
template <int D>
void add_run_in(RegistryIn<D>& to) {
  const auto scene = [](auto member) { return [=](const MeasuredIn<D>& run) { return run.record.scene.*member; }; };
  const auto fact = [](auto member) { return [=](const MeasuredIn<D>& run) { return run.record.facts.*member; }; };
  const auto add = [&](MeasureIn<D> measure) { to.measures.push_back(std::move(measure)); };
  add(measure<D>("title", "", "of the scene", scene(&Scene::title)));
  add(measure<D>("repose_version", "", "of the program", [](const MeasuredIn<D>&) { return std::string(version); }));
  add(measure<D>("method", "", "`method.kind` of the scene",
                 [](const MeasuredIn<D>& run) { return std::string(run.record.scene.method->name()); }));
  add(of_run(measure<D>("seed", "", "of everything random", scene(&Scene::seed))));
  add(measure<D>("status", "", "\"running\", \"finished\", \"interrupted\" or \"failed\"",
                 [](const MeasuredIn<D>& run) { return status_text(run.record.facts.status); }));
  add(measure<D>("stop_reason", "", "why the run stopped", fact(&RunFacts::message)));
  add(of_run(measure<D>("warnings", "", "what makes the results doubtful, a text each; empty if nothing does",
                        [](const MeasuredIn<D>& run) { return warnings_of(run.record); })));
  add(measure<D>("grains", "", "moving grains present",
                 [](const MeasuredIn<D>& run) { return moving_count(*run.record.grains); }));
  add(measure<D>("grains_released", "", "grains that the source has released", fact(&RunFacts::released)));
  add(measure<D>("grains_lost", "", "grains that left through an open end", fact(&RunFacts::lost)));
  add(measure<D>("contacts", "",
                 "contacts that push or pull with more than `force_threshold`; in a deposition all, by geometry",
                 [](const MeasuredIn<D>& run) { return contacts(run); }));
  add(of_run(measure<D>(
      "force_scale", "", "`analysis.force_scale` of the scene",
      [](const MeasuredIn<D>& run) { return run.record.scene.analysis.force_scale; }, Needs::forces)));
  add(of_run(measure<D>(
      "force_unit", "M L/T^2", "what that is in the state",
      [](const MeasuredIn<D>& run) { return run.results.force_unit; }, Needs::forces)));
  add(of_run(measure<D>(
      "force_threshold", "force units", "`analysis.force_threshold` of the scene",
      [](const MeasuredIn<D>& run) { return run.record.scene.analysis.force_threshold; }, Needs::forces)));
  add(measure<D>("time", "T", "of the state; in a deposition it counts discs", fact(&RunFacts::time)));
  add(of_run(measure<D>("steps", "", "time steps taken", fact(&RunFacts::steps))));
  add(of_run(measure<D>("time_step", "T", "of the method", fact(&RunFacts::time_step))));
  add(measure<D>(
      "velocities", "", "those that forces depend on: \"half-step\" or \"synchronised\"",
      [](const MeasuredIn<D>& run) {
        return std::string(run.record.scene.synchronised() ? "synchronised" : "half-step");
      },
      Needs::forces));
  add(of_run(measure<D>("threads", "", "of the program", fact(&RunFacts::threads))));
  add(of_run(measure<D>("wall_seconds", "s", "wall time of the run", fact(&RunFacts::wall_seconds))));
  add(of_run(measure<D>("grain_steps_per_second", "1/s", "moving grains times steps over wall time",
                        [](const MeasuredIn<D>& run) { return grain_steps_per_second(run.record.facts); })));
  add(measure<D>("kinetic_energy_per_grain", "M L^2/T^2", "at the last observation",
                 last(&SeriesRow::kinetic_energy_per_grain), Needs::forces));
  add(measure<D>(
      "force_residual", "",
      "mean net force on a moving grain over its weight (without gravity, over the mean normal force), at the last "
      "observation",
      last(&SeriesRow::force_residual), Needs::forces));
  add(measure<D>("max_overlap", "", "deepest overlap over the mean diameter of the pair",
                 [](const MeasuredIn<D>& run) { return run.results.max_overlap; }));
}

void add_run(Registry& to) { add_run_in(to); }
void add_run(RegistryIn<3>& to) { add_run_in(to); }

/// The exact state.
template <int D>
void add_state_in(RegistryIn<D>& to) {
  to.measures.push_back(measure<D>(
      "state_hash", "",
      "XXH3-128 of the exact bits of places, velocities, spins, radii, masses and contact histories, in order of id: "
      "equal for any number of threads and after any interruption",
      [](const MeasuredIn<D>& run) { return run.record.facts.state_hash; }));
}

void add_state(Registry& to) { add_state_in(to); }
void add_state(RegistryIn<3>& to) { add_state_in(to); }

}  // namespace repose
