// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/hand_to_slurm.hpp"
#include "repose/cli/run_sweep.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/sweep_view.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/sweep/folder.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace repose {

namespace {

struct SweepOptions {
  std::string file;
  std::string out;
  int processes = 0;
  std::string part;     // I/N
  double lease = 60.0;  // [s]
  SlurmOptions slurm;
  bool overwrite = false;
  bool collect = false;
  bool dry = false;
  bool quick = false;
  bool quiet = false;

  SweepForm form() const { return quick ? SweepForm::quick : SweepForm::full; }
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

std::optional<SweepPart> part_of(const SweepOptions& options) {
  if (options.part.empty()) return std::nullopt;
  SweepPart part{.patience = options.lease};
  char rest = 0;
  const int read = std::sscanf(options.part.c_str(), "%d/%d%c", &part.number, &part.parts, &rest);
  if (read != 2 || part.number < 1 || part.number > part.parts) {
    throw InputError(fmt::format("--share {}: must be I/N, the part I of N parts, from 1 to N", options.part));
  }
  if (options.overwrite) throw InputError("--overwrite: one of several that share a sweep cannot remove it");
  return part;
}

/// Throws InputError where options exclude each other.
void check_slurm(const SweepOptions& options) {
  const auto& slurm = options.slurm;
  if (slurm.wanted && (!options.part.empty() || options.collect || options.overwrite || options.dry)) {
    throw InputError("--slurm: writes a batch script alone; not with --share, --collect, --overwrite or --check");
  }
  if (!slurm.wanted && (slurm.tasks > 0 || !slurm.time.empty() || !slurm.partition.empty() || slurm.submit)) {
    throw InputError("--array, --time, --partition, --submit: only with --slurm");
  }
}

int act(const SweepOptions& options) {
  check_slurm(options);
  const auto part = part_of(options);
  if (options.collect && (part || options.overwrite || options.dry)) {
    throw InputError("--collect: writes tables alone; not with --share, --overwrite or --check");
  }
  if (options.collect) return collect_sweep(folder_for(options), options.quiet);
  if (options.slurm.wanted) {
    return hand_to_slurm({.file = options.file,
                          .folder = folder_for(options),
                          .form = options.form(),
                          .cores = options.processes,
                          .lease = options.lease,
                          .quiet = options.quiet},
                         options.slurm);
  }
  const SweepRun wanted{.file = options.file,
                        .folder = folder_for(options),
                        .form = options.form(),
                        .processes = options.processes,
                        .part = part,
                        .overwrite = options.overwrite,
                        .quiet = options.quiet};
  if (!options.dry) return run_sweep(wanted);
  const auto plan = read_sweep(wanted.file, wanted.form);
  const auto problems = SweepFolder::problems(wanted.folder, plan, wanted.overwrite);
  if (!problems.empty()) throw InputError(problems);
  say("{}", describe_plan(plan));
  return 0;
}

}  // namespace

Verb sweep_verb() {
  auto options = std::make_shared<SweepOptions>();
  return {
      .name = "sweep",
      .about = "Run an ensemble, parameters times seeds, over all cores",
      .details =
          "Writes means with standard errors and verdicts on claims. The same command continues a sweep "
          "after a stop of any kind.",
      .arguments =
          {{.name = "SWEEP",
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
                            "Members that run side by side, at most one per core (default); with --slurm "
                            "the cores of a task (4)"),
           {.name = "--quick",
            .about = "Run the small form that the table [quick] of the sweep describes",
            .target = &options->quick},
           {.name = "--share",
            .value = "I/N",
            .about = "Be part I of N programs that share the sweep, here or on other machines",
            .target = &options->part},
           {.name = "--lease",
            .value = "SECONDS",
            .about = "With --share or --slurm: a program that has not stirred for so long is dead; its members are "
                     "taken over (60)",
            .target = &options->lease,
            .bound = {.least = 1, .most = 86400}},
           {.name = "--collect",
            .about = "Write the tables of the members that have finished, and run none",
            .target = &options->collect},
           {.name = "--slurm",
            .about = "Write a batch script of Slurm whose tasks share the sweep, into its folder",
            .target = &options->slurm.wanted},
           {.name = "--array",
            .value = "N",
            .about = "With --slurm: the number of tasks (at most 4, fewer for few members)",
            .target = &options->slurm.tasks,
            .bound = {.least = 1, .most = 1000}},
           {.name = "--time",
            .value = "T",
            .about = "With --slurm: the time of a task, after which it is queued again (24:00:00)",
            .target = &options->slurm.time},
           {.name = "--partition",
            .value = "P",
            .about = "With --slurm: the partition of the tasks (default: that of Slurm)",
            .target = &options->slurm.partition},
           {.name = "--submit", .about = "With --slurm: submit the script by sbatch", .target = &options->slurm.submit},
           overwrite_argument(options->overwrite, "Remove a sweep that the folder already holds"),
           {.name = "--check",
            .about = "Check the sweep and describe its runs, without running",
            .target = &options->dry},
           quiet_argument(options->quiet)},
      .examples = {{"repose sweep examples/sweeps/spacing.toml --check", "List the members and what they cost"},
                   {"repose sweep examples/sweeps/spacing.toml --out spacing",
                    "Run ten heaps on each of several bases; repeat the command to continue"},
                   {"repose plot spacing", "Draw the means"},
                   {"repose sweep examples/sweeps/spacing.toml --out cluster --slurm --array 2",
                    "Write cluster/slurm/batch.sh, to be submitted by sbatch"}},
      .act = [options] { return act(*options); }};
}

}  // namespace repose
