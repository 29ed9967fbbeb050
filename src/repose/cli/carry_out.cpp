// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"

#include "repose/cli/describe.hpp"
#include "repose/cli/progress.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace repose {

int threads_for(const Scene& scene, int wanted) {
  if (wanted > 0) return wanted;
  constexpr std::int64_t grains_per_thread = 2000;
  const auto of_source = scene.source->released() + scene.source->placed();
  const auto grains = of_source + scene.start.moving + static_cast<std::int64_t>(scene.placed.size());
  const auto useful = std::max<std::int64_t>(1, grains / grains_per_thread);
  return static_cast<int>(std::min<std::int64_t>(useful, std::max(1U, std::thread::hardware_concurrency())));
}

int carry_out(Simulation& simulation, RunFolder& folder, bool quiet) {
  catch_signals();
  Progress progress(simulation.scene(), !quiet);
  simulation.observe_every(simulation.scene().output.series, [&](const Simulation& s) { progress.update(s); });
  folder.run(simulation, interrupted);
  progress.finish();
  std::string result;
  folder.write(simulation,
               [&](const Record& record, const Results& results) { result = describe_result(record, results); });
  if (simulation.status() == Status::failed) throw RunError(simulation.message());
  const bool stopped = simulation.status() == Status::interrupted;
  if (!quiet) {
    fmt::print("{}", result);
    if (stopped) fmt::print("to continue      repose resume {}\n", folder.path());
  }
  return stopped ? exit_interrupted : 0;
}

}  // namespace repose
