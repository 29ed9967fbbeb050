// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/progress.hpp"
#include "repose/cli/scene_options.hpp"
#include "repose/cli/signals.hpp"
#include "repose/core/errors.hpp"
#include "repose/run/run_folder.hpp"
#include "repose/run/simulation.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

namespace repose {

namespace {

struct RunOptions {
  SceneOptions scene;
  std::string out;
  int threads = 0;
  bool overwrite = false;
  bool quiet = false;
};

/// As many threads as have enough to do.
int threads_for(const Scene& scene, int wanted) {
  if (wanted > 0) return wanted;
  constexpr std::int64_t grains_per_thread = 2000;
  const auto grains = scene.source.count + static_cast<std::int64_t>(scene.placed.size());
  const auto useful = std::max<std::int64_t>(1, grains / grains_per_thread);
  return static_cast<int>(std::min<std::int64_t>(useful, std::max(1U, std::thread::hardware_concurrency())));
}

int act(const RunOptions& options) {
  const std::string out = options.out.empty() ? std::filesystem::path(options.scene.file).stem().string() : options.out;
  std::vector<std::string> problems = RunFolder::problems(out, options.overwrite);
  std::optional<Scene> scene;
  try {
    scene = options.scene.read();
  } catch (const InputError& error) {
    problems.insert(problems.begin(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) throw InputError(problems);

  Simulation simulation(*scene, threads_for(*scene, options.threads));
  RunFolder folder(out, simulation);
  if (!options.quiet) {
    fmt::print("{}", describe(*scene));
    fmt::print("threads          {}\noutput           {}\n", simulation.threads(), out);
  }
  catch_signals();
  Progress progress(*scene, !options.quiet);
  Simulation::Hooks hooks;
  hooks.observed = [&](const Simulation& s) { progress.update(s); };
  hooks.frame = [&](const Simulation& s) { folder.write(s, true); };
  simulation.run(hooks, interrupted);
  progress.finish();
  folder.write(simulation, false);
  if (simulation.status() == Status::failed) throw RunError(simulation.message());
  if (!options.quiet) {
    const auto record = simulation.record();
    fmt::print("{}", describe_result(record, read(record)));
  }
  return simulation.status() == Status::interrupted ? exit_interrupted : 0;
}

}  // namespace

Command add_run(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  auto* command = app.add_subcommand("run", "Run a scene and write its run folder");
  options->scene.add_to(*command);
  command->add_option("--out", options->out, "Folder to write (default: the name of the scene, here)");
  command->add_option("--threads", options->threads, "Threads; the results do not depend on it (default: as useful)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--overwrite", options->overwrite, "Replace a run that is in the folder already");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
