// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/run_folder/resume.hpp"

#include "repose/cli/carry_out.hpp"
#include "repose/cli/commands.hpp"
#include "repose/core/errors.hpp"
#include "repose/sweep/folder.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
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

int act(const ResumeOptions& options) {
  if (SweepFolder::is_one(options.folder)) {
    throw InputError(
        fmt::format("{0}: is a sweep, not a run: repose sweep {0}/sweep.toml goes on with it", options.folder));
  }
  auto found = find_interrupted(options.folder);
  for (const auto& problem : found.damaged) {
    fmt::print(stderr, "repose: {}{}\n", problem, found.checkpoint ? "; going on from the other checkpoint" : "");
  }
  if (found.finished) {
    if (!options.quiet) {
      fmt::print("{}: the run is finished{}\n", options.folder,
                 found.completed ? "; its analysis was cut off and has been made now" : "");
    }
    return 0;
  }
  Simulation simulation(found.scene, threads_for(found.scene, options.threads));
  const auto frames =
      found.checkpoint ? damaged_frames(options.folder, found.checkpoint->frames()) : std::vector<std::string>();
  for (const auto& problem : frames) fmt::print(stderr, "repose: {}; this frame is lost\n", problem);
  auto folder = resumed_folder(options.folder, found, simulation);
  if (!options.quiet) {
    fmt::print("resumed          at time {:.6g}, step {}{}\n", simulation.time(), simulation.steps(),
               found.checkpoint ? "" : ": there was no checkpoint yet");
    fmt::print("threads          {}\noutput           {}\n", simulation.threads(), options.folder);
  }
  return carry_out(simulation, *folder, options.quiet);
}

}  // namespace

Command add_resume(CLI::App& app) {
  auto options = std::make_shared<ResumeOptions>();
  auto* command =
      app.add_subcommand("resume", "Go on with a run that was interrupted or cut off, as if it had never stopped");
  command->add_option("DIR", options->folder, "Run folder")->required();
  add_threads(*command, options->threads);
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
