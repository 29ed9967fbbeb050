// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/run_sweep.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/sweep_view.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/sweep/folder.hpp"

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
  bool quick = false;
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

int act(const SweepOptions& options) {
  SweepRun wanted{.file = options.file,
                  .folder = folder_for(options),
                  .form = options.quick ? SweepForm::quick : SweepForm::full,
                  .processes = options.processes,
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
                        {.name = "--quick",
                         .about = "Run the small form that the table [quick] of the sweep describes",
                         .target = &options->quick},
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
