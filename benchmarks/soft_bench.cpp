// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed_scene.hpp"
#include "repose/methods/soft/soft.hpp"
#include "repose/scene/read.hpp"
#include "repose/simulation/methods.hpp"
#include "repose/simulation/simulation.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

// Speed of the soft method on real states, in moving grain-steps per second of CPU time for one thread, and of wall
// time where threads are compared. Compare only ratios within one run.

namespace repose::bench {
namespace {

const HookeCumulative hooke_cumulative{Hooke{stiffness, 0.15}, Cumulative{0.5, 1.214}};

const Bed& bed_of(int copies) {
  static std::map<int, Bed> beds;
  if (!beds.contains(copies)) beds.emplace(copies, read_bed(REPOSE_BED, copies));
  return beds.at(copies);
}

void set_rate(benchmark::State& state, double steps, std::size_t grains) {
  state.counters["grain_steps"] = benchmark::Counter(steps * static_cast<double>(grains), benchmark::Counter::kIsRate);
}

/// Steps of copies of the bed side by side. The first argument is the number of copies, the second that of threads.
template <class Law>
void bed(benchmark::State& state, const Law& law) {
  const auto& start = bed_of(static_cast<int>(state.range(0)));
  auto grains = start.grains;
  const auto method = make_kernel<2>(MaterialTable(law), settings_of(start));
  const auto& pairs = dynamic_cast<const Soft<2, Law>&>(*method).pairs();
  Team team(static_cast<int>(state.range(1)));
  method->grains_added(grains);
  const long steps = std::max(10L, 500 / static_cast<long>(state.range(0)));
  const double duration = method->time_steps().after(steps);
  method->advance(grains, duration, team);
  const auto builds = pairs.builds();
  long taken = 0;
  for (auto _ : state) {
    if (method->advance(grains, method->time() + duration, team).trouble) state.SkipWithError("the bed has exploded");
    taken += steps;
  }
  set_rate(state, static_cast<double>(taken), moving_count(grains));
  state.counters["steps_per_build"] =
      static_cast<double>(taken) / static_cast<double>(std::max(1L, pairs.builds() - builds));
}

void bed_hooke_linear(benchmark::State& state) { bed(state, hooke_linear()); }
void bed_hooke_cumulative(benchmark::State& state) { bed(state, hooke_cumulative); }

BENCHMARK(bed_hooke_linear)->ArgNames({"copies", "threads"})->Args({1, 1})->MinTime(2.0);
BENCHMARK(bed_hooke_cumulative)->ArgNames({"copies", "threads"})->Args({1, 1})->MinTime(2.0);
BENCHMARK(bed_hooke_linear)
    ->Name("bed_threads")
    ->ArgNames({"copies", "threads"})
    ->Args({1, 1})
    ->Args({1, 2})
    ->Args({10, 1})
    ->Args({10, 2})
    ->MinTime(2.0)
    ->UseRealTime();
BENCHMARK(bed_hooke_linear)->Name("bed_large")->ArgNames({"copies", "threads"})->Args({100, 1})->Iterations(6);

/// The first 600 grains of examples/heap.toml, poured faster, so that this takes seconds. The last grains are in
/// flight.
const Simulation& growing_heap() {
  static const auto simulation = [] {
    Overrides overrides;
    overrides.set = {"source.rate=4", "stop.time=170"};
    auto made = std::make_unique<Simulation>(read_scene(REPOSE_EXAMPLES "/heap.toml", overrides), 1);
    made->run();
    return made;
  }();
  return *simulation;
}

/// Steps of a heap with the continuous law (n = 36, r0 = 1.2), cumulative friction and some grains in flight.
void heap_continuous(benchmark::State& state) {
  const auto& heap = growing_heap();
  auto grains = heap.grains();
  const auto method = make_method(heap.scene());
  Team team(1);
  method->grains_added(grains);
  const double duration = method->time_steps().after(500);
  long taken = 0;
  for (auto _ : state) {
    if (method->advance(grains, method->time() + duration, team).trouble) state.SkipWithError("the heap has exploded");
    taken += 500;
  }
  set_rate(state, static_cast<double>(taken), moving_count(grains));
}
BENCHMARK(heap_continuous)->Iterations(20);

/// The whole cost of a new pair list (sorting, listing, slip displacements, distribution among threads) after every
/// grain has moved.
void pair_list_build(benchmark::State& state) {
  const auto& start = bed_of(static_cast<int>(state.range(0)));
  auto grains = start.grains;
  const auto method = make_kernel<2>(MaterialTable(hooke_linear()), settings_of(start));
  Team team(static_cast<int>(state.range(1)));
  method->grains_added(grains);
  method->refresh(grains, team);
  double displacement = settings_of(start).skin;
  for (auto _ : state) {
    state.PauseTiming();
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const double phase = static_cast<double>(grains.id[i]);
      grains.line[i].position += Vec<2>{{std::cos(phase), std::sin(phase)}} * displacement;
    }
    displacement = -displacement;
    state.ResumeTiming();
    method->refresh(grains, team);
  }
  state.counters["seconds_per_grain"] =
      benchmark::Counter(static_cast<double>(grains.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(pair_list_build)
    ->ArgNames({"copies", "threads"})
    ->Args({1, 1})
    ->Args({10, 1})
    ->Args({10, 2})
    ->Args({100, 1})
    ->UseRealTime();

}  // namespace
}  // namespace repose::bench

BENCHMARK_MAIN();
