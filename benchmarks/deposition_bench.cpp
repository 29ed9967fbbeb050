// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Discs per second of the method `deposition`, by critical angle and size, on a contiguous row. The last number of a
// name is the number of discs. `peak_mib` is the largest memory of the process so far.
#include "measured.hpp"
#include "repose/core/random.hpp"
#include "repose/methods/deposition/deposition.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>
#include <vector>

namespace repose {
namespace {

void deposit(benchmark::State& state) {
  const auto width = state.range(1);
  DepositionSettings settings;
  settings.critical_angle_deg = static_cast<double>(state.range(0));
  settings.box.periodic = true;
  settings.box.x_min = 0.0;
  settings.box.x_max = static_cast<double>(width);
  settings.floor = -0.5;
  settings.snapped = state.range(0) == 0;
  settings.count = state.range(2);
  settings.draw = [](std::int64_t k, std::span<DroppedDisc> discs) {
    for (auto& disc : discs) {
      disc.place = uniform(1, Purpose::release_position, static_cast<std::uint64_t>(k++));
      disc.radius = 0.5;
      disc.mass = 1.0;
    }
  };
  Team team(1);
  for (auto _ : state) {
    Grains<2> grains;
    const auto method = make_deposition(settings);
    grains.reserve(static_cast<std::size_t>(width + settings.count));
    for (long k = 0; k < width; ++k) {
      Grain<2> fixed;
      fixed.radius = 0.5;
      fixed.mass = 1.0;
      fixed.position = Vec<2>{{static_cast<double>(k) + 0.5, 0.0}};
      grains.add(fixed, k, true);
    }
    method->grains_added(grains);
    benchmark::DoNotOptimize(method->advance(grains, static_cast<double>(settings.count), team));
  }
  state.counters["discs"] =
      benchmark::Counter(static_cast<double>(state.iterations() * settings.count), benchmark::Counter::kIsRate);
  state.counters["peak_mib"] = bench::peak_memory();
}

// Widths and sizes are those of benchmarks/driver/deposition.py.
void sizes(benchmark::internal::Benchmark* cases, const std::vector<std::pair<long, long>>& of) {
  for (const long angle : {90L, 50L, 0L}) {
    for (const auto& [width, discs] : of) cases->Args({angle, width, discs});
  }
}

BENCHMARK(deposit)
    ->ArgNames({"angle", "width", "discs"})
    ->Apply([](auto* cases) {
      sizes(cases, {{32, 1'000}, {100, 10'000}, {316, 100'000}});
    }) -> Unit(benchmark::kMillisecond);
BENCHMARK(deposit)
    ->ArgNames({"angle", "width", "discs"})
    ->Apply([](auto* cases) {
      sizes(cases, {{1000, 1'000'000}, {10000, 10'000'000}});
    }) -> Iterations(1) -> Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace repose

BENCHMARK_MAIN();
