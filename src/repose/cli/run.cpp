// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"
#include "repose/cli/commands.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/scene_options.hpp"
#include "repose/core/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace repose {

namespace {

struct RunOptions {
  SceneOptions scene;
  std::string out;
  int threads = 0;
  bool overwrite = false;
  bool quiet = false;
};

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
  return carry_out(simulation, folder, options.quiet);
}

}  // namespace

Command add_run(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  auto* command = app.add_subcommand("run", "Run a scene and write its run folder");
  options->scene.add_to(*command);
  command->add_option("--out", options->out, "Folder to write (default: the name of the scene, here)");
  add_threads(*command, options->threads);
  command->add_flag("--overwrite", options->overwrite, "Replace a run that is in the folder already");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
