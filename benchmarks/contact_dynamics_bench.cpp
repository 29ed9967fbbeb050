// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contact-iterations per second of contact dynamics in a bed that was settled in a periodic box: a contact visited by a
// sweep, one way, is one. `sweeps` measures the solver at work from no impulses, `steps` whole steps with warm start.
#include "repose/core/random.hpp"
#include "repose/methods/contact_dynamics/contact_dynamics.hpp"

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
    // Shifted sideways, or columns would stand.
    const double shift = 0.1 * uniform(1, Purpose::release_position, index);
    grain.position = {{0.4 + k % width + shift, 0.6 + 1.05 * static_cast<double>(k / width)}};
    bed.grains.add(grain, k);
  }
  bed.method->grains_added(bed.grains);
  Team team(1);
  bed.method->advance(bed.grains, 600, team);
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
    bed.method->advance(bed.grains, 10, team);
    moved += 10.0 * static_cast<double>(bed.grains.size());
  }
  state.counters["grain_steps"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}

BENCHMARK(sweeps)->ArgNames({"discs", "accelerated"})->ArgsProduct({{1000, 10000}, {0, 1}});
BENCHMARK(steps)->ArgName("discs")->Arg(1000);

}  // namespace
}  // namespace repose

BENCHMARK_MAIN();
