// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"

#include "repose/cli/describe.hpp"
#include "repose/cli/progress.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/machine.hpp"
#include "repose/simulation/expectation.hpp"

#include <algorithm>

namespace repose {

int threads_for(const Scene& scene, int wanted) {
  constexpr std::int64_t worth_a_thread = 2000;
  constexpr std::int64_t least_for_a_thread = 10;
  const auto of_source = scene.source->released() + scene.source->placed();
  const auto grains = of_source + scene.start.moving + static_cast<std::int64_t>(scene.placed.size());
  const auto least = wanted > 0 ? least_for_a_thread : worth_a_thread;
  const auto useful = std::clamp<std::int64_t>(grains / least, 1, machine_threads());
  return static_cast<int>(wanted > 0 ? std::min<std::int64_t>(wanted, useful) : useful);
}

void check_memory(const Scene& scene, const std::string& name) {
  const double needed = expected_memory(scene);
  const double room = machine_memory();
  if (needed <= room) return;
  throw InputError(fmt::format(
      "{}: needs about {:.3g} GB of memory, this machine has {:.3g} GB: take fewer grains, or longer intervals "
      "output.series and output.track (`repose run --beyond-memory` runs it all the same)",
      name, needed / 1e9, room / 1e9));
}

template <int D>
int carry_out(Simulation<D>& simulation, RunFolder<D>& folder, bool quiet) {
  catch_signals();
  Progress progress(simulation.scene(), !quiet);
  simulation.observe_every(simulation.scene().output.series, [&](const auto& s) { progress.update(s); });
  folder.run(simulation, interrupted);
  progress.finish();
  std::string result;
  folder.write_last(simulation,
                    [&](const auto& record, const auto& results) { result = describe_result(record, results); });
  if (simulation.status() == Status::failed) throw RunError(simulation.message());
  const bool stopped = simulation.status() == Status::interrupted;
  if (!quiet) {
    say("{}", result);
    if (stopped) say("to continue      repose resume {}\n", folder.path());
  }
  return stopped ? exit_interrupted : 0;
}
template int carry_out(Simulation<2>&, RunFolder<2>&, bool);
template int carry_out(Simulation<3>&, RunFolder<3>&, bool);

}  // namespace repose
