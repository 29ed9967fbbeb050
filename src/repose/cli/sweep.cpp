// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/sweep_view.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/machine.hpp"
#include "repose/simulation/expectation.hpp"
#include "repose/sweep/members.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace repose {

namespace {

struct SweepOptions {
  std::string file;
  std::string out;
  int processes = 0;
  bool overwrite = false;
  bool dry = false;
  bool quiet = false;
};

/// The folder of the sweep; `repose sweep DIR/sweep.toml` continues in DIR.
std::string folder_for(const SweepOptions& options) {
  namespace fs = std::filesystem;
  if (!options.out.empty()) return options.out;
  const fs::path file(options.file);
  std::error_code error;
  if (file.filename() == "sweep.toml" && fs::exists(file.parent_path() / "members", error)) {
    return file.has_parent_path() ? file.parent_path().string() : ".";
  }
  return file.stem().string();
}

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

int act(const SweepOptions& options) {
  const auto out = folder_for(options);
  auto plan = read_sweep(options.file);
  const auto problems = SweepFolder::problems(out, plan, options.overwrite);
  if (!problems.empty()) throw InputError(problems);
  if (options.dry) {
    say("{}", describe_plan(plan));
    return 0;
  }
  const int wanted = processes_for(plan, options.processes > 0 ? options.processes : machine_threads());
  const SweepFolder folder(out, options.file, std::move(plan), options.overwrite);
  Sweep sweep(folder, std::min(wanted, static_cast<int>(folder.members().size())));
  catch_signals();
  SweepView view(folder, sweep, options.quiet);
  sweep.run([&](std::size_t member) { view.ended(member); }, [&] { view.tick(); }, interrupted);
  view.finish();
  const auto table = folder.table();
  folder.write(table);
  if (!options.quiet) say("{}", describe_table(folder, table));
  if (interrupted) return exit_interrupted;
  return sweep.count(MemberProgress::Stage::failed) > 0 ? exit_run_trouble : 0;
}

}  // namespace

Verb sweep_verb() {
  auto options = std::make_shared<SweepOptions>();
  return {.name = "sweep",
          .about = "Run an ensemble, parameters times seeds, over all cores",
          .details =
              "Writes means with standard errors and verdicts on claims. The same command continues a sweep "
              "after a stop of any kind.",
          .arguments = {{.name = "SWEEP",
                         .about = "Sweep file (TOML)",
                         .target = &options->file,
                         .required = true,
                         .completes = Completion::scene_files},
                        {.name = "--out",
                         .value = "DIR",
                         .about = "Folder to write or to continue (default: the name of the file, here)",
                         .target = &options->out,
                         .completes = Completion::folders},
                        threads_argument(options->processes,
                                         "Members that run side by side, at most one per core (default)"),
                        overwrite_argument(options->overwrite, "Remove a sweep that the folder already holds"),
                        {.name = "--check",
                         .about = "Check the sweep and describe its runs, without running",
                         .target = &options->dry},
                        quiet_argument(options->quiet)},
          .examples = {{"repose sweep examples/sweeps/spacing.toml --check", "List the members and what they cost"},
                       {"repose sweep examples/sweeps/spacing.toml --out spacing",
                        "Run ten heaps on each of several bases; repeat the command to continue"},
                       {"repose plot spacing", "Draw the means"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
