// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/signals.hpp"
#include "repose/cli/sweep_view.hpp"
#include "repose/core/errors.hpp"
#include "repose/sweep/members.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

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

/// `repose sweep DIR/sweep.toml` goes on in DIR.
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
  const auto out = folder_for(options);
  auto plan = read_sweep(options.file);
  const auto problems = SweepFolder::problems(out, plan, options.overwrite);
  if (!problems.empty()) throw InputError(problems);
  if (options.dry) {
    fmt::print("{}", describe_plan(plan));
    return 0;
  }
  const SweepFolder folder(out, options.file, std::move(plan), options.overwrite);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int wanted = options.processes > 0 ? options.processes : cores;
  Sweep sweep(folder, std::min(wanted, static_cast<int>(folder.members().size())));
  catch_signals();
  SweepView view(folder, sweep, options.quiet);
  sweep.run([&](std::size_t member) { view.ended(member); }, [&] { view.tick(); }, interrupted);
  view.finish();
  const auto table = folder.table();
  folder.write(table);
  if (!options.quiet) fmt::print("{}", describe_table(folder, table));
  if (interrupted) return exit_interrupted;
  return sweep.count(MemberProgress::Stage::failed) > 0 ? exit_run_trouble : 0;
}

}  // namespace

Command add_sweep(CLI::App& app) {
  auto options = std::make_shared<SweepOptions>();
  auto* command = app.add_subcommand(
      "sweep", "Run an ensemble, parameters times seeds, over all cores; the same command goes on after a stop");
  command->add_option("SWEEP", options->file, "Sweep file (TOML)")->required();
  command->add_option("--out", options->out, "Folder to write or to go on in (default: the name of the file, here)");
  command->add_option("--threads", options->processes, "Members that run side by side (default: one per core)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--overwrite", options->overwrite, "Clear out a sweep that is in the folder already");
  command->add_flag("--check", options->dry, "Read and validate; say what would run");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
