// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contact-iterations per second of contact dynamics in a settled bed in a periodic box. One contact-iteration is a
// visit of a contact by a sweep in one direction. `sweeps` measures the solver from zero impulses, `steps` whole steps
// with warm start, `one_by_one` and `packed` the bare sweeps over single contacts and over packs (instructions: 0
// baseline, 1 AVX2, 2 AVX-512), and `build` the time to put the contacts into packs.
#include "repose/core/aligned.hpp"
#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"
#include "repose/methods/contact_dynamics/line_sweeps.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace repose {
namespace {

struct SettledBed {
  Grains<2> grains;
  std::unique_ptr<ContactDynamics<2>> method;
};

SettledBed& settled_bed(int count) {
  static std::map<int, SettledBed> beds;
  auto& bed = beds[count];
  if (bed.method) return bed;
  const int width = count / 20;
  ContactDynamicsSettings<2> settings;
  settings.time_step = 0.05;
  settings.gravity = {{0.0, -1.0}};
  settings.box.periodic = true;
  settings.box.x_min = 0.0;
  settings.box.x_max = width;
  settings.walls.resize(1);
  settings.walls[0].normal = {{0.0, 1.0}};
  settings.solver.tolerance = 1e-4;
  settings.solver.most_sweeps = 60;
  ImpulseLaw law;
  law.friction = 0.5;
  bed.method = std::make_unique<ContactDynamics<2>>(ImpulseLaws(law), settings);
  for (int k = 0; k < count; ++k) {
    const auto index = static_cast<std::uint64_t>(k);
    Grain<2> grain;
    grain.radius = 0.4 + 0.1 * uniform(1, Purpose::grain_size, index);
    grain.mass = 4.0 * grain.radius * grain.radius;
    grain.inverse_mass = 1.0 / grain.mass;
    // Rows are shifted sideways, because straight columns would stand.
    const double shift = 0.1 * uniform(1, Purpose::release_position, index);
    grain.position = {{0.4 + k % width + shift, 0.6 + 1.05 * static_cast<double>(k / width)}};
    bed.grains.add(grain, k);
  }
  bed.method->grains_added(bed.grains);
  Team team(1);
  bed.method->advance(bed.grains, bed.method->time_steps().after(600), team);
  return bed;
}

void sweeps(benchmark::State& state) {
  const auto& bed = settled_bed(static_cast<int>(state.range(0)));
  contact_dynamics::SolverSettings settings;
  settings.tolerance = 0.0;
  settings.most_sweeps = 100;
  settings.accelerated = state.range(1) != 0;
  contact_dynamics::Solver<2> solver(settings);
  auto problem = bed.method->problem();
  double visits = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    for (auto& c : problem.contacts) c.impulse = {};
    state.ResumeTiming();
    const auto solution = solver.solve(problem);
    visits += 2.0 * static_cast<double>(solution.sweeps) * static_cast<double>(problem.contacts.size());
  }
  state.counters["contact_iterations"] = benchmark::Counter(visits, benchmark::Counter::kIsRate);
  state.counters["contacts"] = static_cast<double>(problem.contacts.size());
}

void steps(benchmark::State& state) {
  auto& bed = settled_bed(static_cast<int>(state.range(0)));
  Team team(1);
  double moved = 0.0;
  for (auto _ : state) {
    bed.method->advance(bed.grains, bed.method->time() + bed.method->time_steps().after(10), team);
    moved += 10.0 * static_cast<double>(bed.grains.size());
  }
  state.counters["grain_steps"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}

void count_visits(benchmark::State& state, std::size_t contacts, double sweeps_each) {
  state.counters["contact_iterations"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * sweeps_each * static_cast<double>(contacts),
                         benchmark::Counter::kIsRate);
  state.counters["contacts"] = static_cast<double>(contacts);
}

/// A settled bed before its contacts act.
contact_dynamics::Problem<2> problem_of_bed(int count, bool rolling) {
  auto problem = settled_bed(count).method->problem();
  problem.rolling = rolling;
  problem.bodies = problem.free;
  for (auto& c : problem.contacts) {
    c.impulse = {};
    if (rolling) c.rolling_friction = 0.1;
  }
  return problem;
}

void one_by_one(benchmark::State& state) {
  auto problem = problem_of_bed(static_cast<int>(state.range(0)), state.range(1) != 0);
  contact_dynamics::LineSweeps<2> sweeps;
  auto changes = sweeps.impulses(problem);
  contact_dynamics::History history;
  history.change = changes.data();
  const auto& kernels = contact_dynamics::kernels_of(chosen_instruction_set());
  Team alone(1);
  for (auto _ : state) sweeps.sweep_both_ways(problem, nullptr, {}, history, kernels, alone);
  count_visits(state, problem.contacts.size(), 2.0);
}

void packed(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(2));
  if (!has(set)) return state.SkipWithError("not on this machine");
  auto problem = problem_of_bed(static_cast<int>(state.range(0)), state.range(1) != 0);
  contact_dynamics::Packs packs;
  packs.build(problem);
  AlignedDoubles impulses(packs.size() * packs.numbers());
  AlignedDoubles changes(impulses.size());
  packs.load(problem.contacts, impulses.data());
  packs.add_bodies(problem.bodies);
  Team alone(1);
  contact_dynamics::PackSweep sweep;
  sweep.impulses = impulses.data();
  sweep.bodies = problem.bodies.data();
  sweep.history.change = changes.data();
  for (auto _ : state) packs.sweep_both_ways(sweep, contact_dynamics::kernels_of(set), alone);
  count_visits(state, problem.contacts.size(), 2.0);
  state.counters["filling"] = static_cast<double>(problem.contacts.size()) / static_cast<double>(8 * packs.size());
}

void build(benchmark::State& state) {
  const auto problem = problem_of_bed(static_cast<int>(state.range(0)), false);
  contact_dynamics::Packs packs;
  for (auto _ : state) packs.build(problem);
  count_visits(state, problem.contacts.size(), 1.0);
}

BENCHMARK(one_by_one)->ArgNames({"discs", "rolling"})->ArgsProduct({{1000, 10000}, {0, 1}});
BENCHMARK(packed)->ArgNames({"discs", "rolling", "instructions"})->ArgsProduct({{1000, 10000}, {0, 1}, {1, 2, 3}});
BENCHMARK(build)->ArgName("discs")->Arg(1000)->Arg(10000);
BENCHMARK(sweeps)->ArgNames({"discs", "accelerated"})->ArgsProduct({{1000, 10000}, {0, 1}});
BENCHMARK(steps)->ArgName("discs")->Arg(1000);

}  // namespace
}  // namespace repose

BENCHMARK_MAIN();
