// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed_scene.hpp"
#include "repose/run/setup.hpp"
#include "repose/run/simulation.hpp"
#include "repose/scene/read.hpp"

#include <benchmark/benchmark.h>

#include <atomic>
#include <cmath>
#include <map>
#include <memory>

// Speed of the soft method on real states, in moving grain-steps per second: of CPU time for one thread, of wall time
// for several. Compare ratios within one run only.

namespace repose::bench {
namespace {

const PairLaw<Hooke, Cumulative> hooke_cumulative{Hooke{stiffness, 0.15}, Cumulative{0.5, 1.214}};

const Bed& bed_of(int copies) {
  static std::map<int, Bed> beds;
  if (!beds.contains(copies)) beds.emplace(copies, read_bed(REPOSE_BED, copies));
  return beds.at(copies);
}

void set_rate(benchmark::State& state, double grain_steps) {
  state.counters["grain_steps"] = benchmark::Counter(grain_steps, benchmark::Counter::kIsRate);
}

template <class Law>
void bed(benchmark::State& state, const Law& law) {
  const auto& start = bed_of(static_cast<int>(state.range(0)));
  auto grains = start.grains;
  const auto settings = settings_of(start);
  Soft<2, Law> method(soft::LawsOfMaterials<Law>(law), settings);
  Team team(static_cast<int>(state.range(1)));
  method.grains_added(grains);
  method.advance(grains, 200, team);
  const long steps = std::max(10L, 2000 / static_cast<long>(state.range(0)));
  const auto builds = method.pairs().builds();
  long taken = 0;
  for (auto _ : state) {
    method.advance(grains, steps, team);
    taken += steps;
  }
  set_rate(state, static_cast<double>(taken) * static_cast<double>(moving_count(grains)));
  state.counters["steps_per_build"] =
      static_cast<double>(taken) / static_cast<double>(std::max(1L, method.pairs().builds() - builds));
}

void bed_hooke_linear(benchmark::State& state) { bed(state, hooke_linear()); }
void bed_hooke_cumulative(benchmark::State& state) { bed(state, hooke_cumulative); }

BENCHMARK(bed_hooke_linear)->ArgNames({"copies", "threads"})->Args({1, 1});
BENCHMARK(bed_hooke_cumulative)->ArgNames({"copies", "threads"})->Args({1, 1});
BENCHMARK(bed_hooke_linear)
    ->Name("bed_threads")
    ->ArgNames({"copies", "threads"})
    ->Args({10, 1})
    ->Args({10, 2})
    ->UseRealTime();
BENCHMARK(bed_hooke_linear)->Name("bed_large")->ArgNames({"copies", "threads"})->Args({100, 1})->Iterations(3);

/// The heap of examples/heap.toml while 600 grains have been poured, with grains still falling.
const Simulation& growing_heap() {
  static const auto simulation = [] {
    Overrides overrides;
    overrides.set = {"stop.time=970", "source.count=2000"};
    auto made = std::make_unique<Simulation>(read_scene(REPOSE_EXAMPLES "/heap.toml", overrides), 1);
    const std::atomic<bool> interrupt{false};
    made->run({}, interrupt);
    return made;
  }();
  return *simulation;
}

void heap_continuous(benchmark::State& state) {
  const auto& heap = growing_heap();
  auto grains = heap.grains();
  const auto method = make_method(heap.scene());
  Team team(1);
  method->grains_added(grains);
  method->advance(grains, 500, team);
  long taken = 0;
  for (auto _ : state) {
    method->advance(grains, 500, team);
    taken += 500;
  }
  set_rate(state, static_cast<double>(taken) * static_cast<double>(moving_count(grains)));
}
BENCHMARK(heap_continuous);

/// Building the pair list (sort, list, histories), in seconds per grain.
void pair_list_build(benchmark::State& state) {
  const auto& start = bed_of(static_cast<int>(state.range(0)));
  auto grains = start.grains;
  PairList<2> pairs({.cutoff = 1.0, .skin = 0.3, .horizon = 0.05, .gravity = 1.0});
  Team team(static_cast<int>(state.range(1)));
  for (auto _ : state) pairs.build(grains, start.box, team);
  state.counters["seconds_per_grain"] =
      benchmark::Counter(static_cast<double>(grains.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(pair_list_build)
    ->ArgNames({"copies", "threads"})
    ->Args({1, 1})
    ->Args({100, 1})
    ->Args({100, 2})
    ->UseRealTime();

}  // namespace
}  // namespace repose::bench

BENCHMARK_MAIN();
