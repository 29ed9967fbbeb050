// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

namespace {

int report(const std::exception& failure, int status) {
  fmt::print(stderr, "{}\n", failure.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace repose;
  // A full disk is reported by the write that meets it, not by a signal that kills the program.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app{"Repose: an open laboratory for the mechanics of granular heaps, packings and columns"};
  app.set_version_flag("--version", version);
  app.require_subcommand(0, 1);
  const auto run = add_run(app);
  const auto check = add_check(app);
  const auto resume = add_resume(app);
  const auto sweep = add_sweep(app);
  const auto analyse = add_analyse(app);
  const auto exports = add_export(app);
  const auto solve = add_solve(app);
  const auto theory = add_theory(app);
  const auto plot = add_plot(app);
  const auto reference = add_reference(app);
  const auto scene = add_scene(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_bad_input;
  }
  try {
    for (const auto& command : {run, check, resume, sweep, analyse, exports, solve, theory, plot, reference, scene}) {
      if (command.app->parsed()) return command.act();
    }
  } catch (const InputError& error) {
    return report(error, exit_bad_input);
  } catch (const std::exception& error) {
    return report(error, exit_run_trouble);
  }
  fmt::print(stderr, "{}", app.help());
  return exit_bad_input;
}
