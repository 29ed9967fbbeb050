// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/resume.hpp"

#include "repose/cli/carry_out.hpp"
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/sweep/folder.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

struct ResumeOptions {
  std::string folder;
  int threads = 0;
  bool quiet = false;
};

template <int D>
int resume_run(InterruptedRun& found, const ResumeOptions& options) {
  Simulation<D> simulation(found.scene, threads_for(found.scene, options.threads));
  const auto frames =
      found.checkpoint ? damaged_frames(options.folder, found.checkpoint->frames()) : std::vector<std::string>();
  for (const auto& problem : frames) complain("repose: {}; this frame is lost\n", problem);
  auto folder = resumed_folder(options.folder, found, simulation);
  if (!options.quiet) {
    say("resumed          at time {:.6g}, step {}{}\n", simulation.time(), simulation.steps(),
        found.checkpoint ? "" : ": no checkpoint existed yet");
    say("threads          {}\noutput           {}\n", simulation.threads(), options.folder);
  }
  return carry_out(simulation, *folder, options.quiet);
}

int act(const ResumeOptions& options) {
  if (SweepFolder::is_one(options.folder)) {
    throw InputError(
        fmt::format("{0}: is a sweep, not a run: `repose sweep {0}/sweep.toml` continues it", options.folder));
  }
  auto found = find_interrupted(options.folder);
  for (const auto& problem : found.damaged) {
    complain("repose: {}{}\n", problem, found.checkpoint ? "; resuming from the other checkpoint" : "");
  }
  if (found.finished) {
    if (!options.quiet) {
      say("{}: the run is finished{}\n", options.folder,
          found.completed ? "; its analysis was missing and has been made" : "");
    }
    return 0;
  }
  return with_dimension(found.scene.dimension, [&](auto dimension) { return resume_run<dimension>(found, options); });
}

}  // namespace

Verb resume_verb() {
  auto options = std::make_shared<ResumeOptions>();
  return {.name = "resume",
          .about = "Continue an interrupted run, to the same bits as if it had never stopped",
          .details = "The run may have been stopped by Ctrl-C or killed at any moment. A finished run stays as it is.",
          .arguments = {folder_argument(options->folder, "Run folder"),
                        threads_argument(options->threads,
                                         "Threads, at most one per core (default: as many as have enough to do)"),
                        quiet_argument(options->quiet)},
          .examples = {{"repose resume heap", "Continue the run in the folder heap"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
