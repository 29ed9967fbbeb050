// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/run_sweep.hpp"

#include "repose/cli/carry_out.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/sweep_view.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/machine.hpp"
#include "repose/simulation/expectation.hpp"
#include "repose/sweep/members.hpp"

#include <algorithm>

namespace repose {

namespace {

/// As many members side by side as are wanted and fit into memory. Throws InputError if one alone does not.
int processes_for(const SweepPlan& plan, int wanted) {
  double largest = 1.0;
  for (const auto& point : plan.points) {
    check_memory(point.scene, point.name);
    largest = std::max(largest, expected_memory(point.scene));
  }
  const auto most = static_cast<double>(std::min(wanted, machine_threads()));
  return static_cast<int>(std::clamp(machine_memory() / largest, 1.0, most));
}

}  // namespace

int run_sweep(const SweepRun& wanted) {
  auto plan = read_sweep(wanted.file, wanted.form);
  const auto problems = SweepFolder::problems(wanted.folder, plan, wanted.overwrite);
  if (!problems.empty()) throw InputError(problems);
  const int processes = processes_for(plan, wanted.processes > 0 ? wanted.processes : machine_threads());
  const SweepFolder folder(wanted.folder, wanted.file, std::move(plan), wanted.overwrite, wanted.form,
                           wanted.part ? FolderLock::For::several : FolderLock::For::one);
  Sweep sweep(folder, std::min(processes, static_cast<int>(folder.members().size())), wanted.part);
  catch_signals();
  SweepView view(folder, sweep, wanted.quiet);
  sweep.run([&](std::size_t member) { view.ended(member); }, [&] { view.tick(); }, interrupted);
  view.finish();
  const auto table = folder.table();
  folder.write(table);
  if (!wanted.quiet && wanted.with_result) say("{}", describe_table(folder, table));
  if (interrupted) return exit_interrupted;
  return sweep.count(MemberProgress::Stage::failed) > 0 ? exit_run_trouble : 0;
}

int collect_sweep(const std::string& path, bool quiet) {
  const SweepFolder folder(path);
  const auto table = folder.table();
  folder.write(table);
  if (!quiet) say("{}", describe_table(folder, table));
  return 0;
}

}  // namespace repose
