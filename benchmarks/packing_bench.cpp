// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/packing.hpp"
#include "repose/core/random.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

// Speed of the packing analysis. Discs lie in memory in order of deposition, so at random in x.

namespace repose::bench {
namespace {

struct Case {
  Discs discs;
  Box<2> box;
};

/// Discs that stick at the first touch (critical angle 90 degrees): a loose packing, many widths high. Only the last 24
/// discs near each position are checked, so a few may overlap.
Case loose_packing(std::size_t deposited) {
  const auto columns = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(deposited))));
  Case packing;
  packing.box.periodic = true;
  packing.box.x_min = 0.0;
  packing.box.x_max = static_cast<double>(columns);
  constexpr std::size_t looked_at = 24;
  std::vector<std::array<std::uint32_t, looked_at>> last(columns);
  for (std::uint32_t k = 0; k < columns; ++k) {
    packing.discs.add({{k + 0.5, 0.0}}, 0.5, true);
    last[k].fill(k);
  }
  for (std::size_t n = 0; n < deposited; ++n) {
    const double x = uniform(1, Purpose::release_position, n) * packing.box.x_max;
    const auto column = static_cast<std::size_t>(x);
    double y = 0.0;
    for (const auto beside : {column + columns - 1, column, column + 1}) {
      for (const auto disc : last[beside % columns]) {
        const auto& below = packing.discs.position[disc];
        const double aside = separation(Vec<2>{{x, 0.0}}, Vec<2>{{below[0], 0.0}}, packing.box)[0];
        if (std::fabs(aside) < 1.0) y = std::max(y, below[1] + std::sqrt(1.0 - aside * aside));
      }
    }
    last[column][n % looked_at] = static_cast<std::uint32_t>(packing.discs.size());
    packing.discs.add({{x, y}}, 0.5);
  }
  return packing;
}

/// The triangular lattice, which has most contacts.
Case dense_packing(std::size_t deposited) {
  const auto columns = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(deposited))));
  Case packing;
  packing.box.periodic = true;
  packing.box.x_min = 0.0;
  packing.box.x_max = static_cast<double>(columns);
  for (std::size_t n = 0; n < deposited + columns; ++n) {
    const auto row = n / columns;
    const double x = static_cast<double>(n % columns) + (row % 2 == 0 ? 0.0 : 0.5);
    packing.discs.add({{x, static_cast<double>(row) * std::sqrt(0.75)}}, 0.5, row == 0);
  }
  return packing;
}

const Case& case_of(bool dense, std::size_t deposited) {
  static std::map<std::pair<bool, std::size_t>, Case> cases;
  auto& found = cases[{dense, deposited}];
  if (found.discs.size() == 0) found = dense ? dense_packing(deposited) : loose_packing(deposited);
  return found;
}

void analyse(benchmark::State& state, const PackingOptions& options) {
  const auto& packing = case_of(state.range(0) != 0, static_cast<std::size_t>(state.range(1)));
  for (auto _ : state) {
    auto result = analyse_packing(packing.discs, packing.box, options);
    if (!result.packing) state.SkipWithError(result.problem.c_str());
    benchmark::DoNotOptimize(result);
  }
  state.counters["discs"] =
      benchmark::Counter(static_cast<double>(packing.discs.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void packing_usual(benchmark::State& state) { analyse(state, {}); }
void packing_correlations(benchmark::State& state) {
  PackingOptions options;
  options.correlations = true;
  analyse(state, options);
}
void packing_structure(benchmark::State& state) {
  PackingOptions options;
  options.structure = true;
  analyse(state, options);
}
void packing_local_density(benchmark::State& state) {
  PackingOptions options;
  options.local_density = true;
  analyse(state, options);
}

BENCHMARK(packing_usual)
    ->ArgNames({"dense", "discs"})
    ->ArgsProduct({{0, 1}, {1000, 100'000, 1'000'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(packing_correlations)
    ->ArgNames({"dense", "discs"})
    ->ArgsProduct({{0, 1}, {1000, 100'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(packing_structure)
    ->ArgNames({"dense", "discs"})
    ->ArgsProduct({{0, 1}, {1000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(packing_local_density)
    ->ArgNames({"dense", "discs"})
    ->ArgsProduct({{0, 1}, {1000}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace repose::bench

BENCHMARK_MAIN();
