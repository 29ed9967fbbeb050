// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/contact_problem/contact_solution.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace repose {

namespace {

struct SolveOptions {
  std::string file;
  std::string out;
  std::string solver = "accelerated";
  contact_dynamics::SolverSettings settings;
  bool warm = false;
  bool overwrite = false;
  bool quiet = false;
};

void check_out(const SolveOptions& options) {
  if (options.out.empty()) return;
  std::error_code error;
  const auto folder = std::filesystem::absolute(options.out).parent_path();
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: no such folder: {}", options.out, folder.string()));
  }
  if (!is_there(options.out)) return;
  if (std::filesystem::equivalent(options.out, options.file, error)) {
    throw InputError(fmt::format("{}: is the problem itself; choose another --out", options.out));
  }
  if (!options.overwrite || !std::filesystem::is_regular_file(options.out, error)) {
    throw InputError(fmt::format("{}: is there already; choose another --out, or --overwrite a file", options.out));
  }
}

void describe(const ContactProblem& solved, const ContactSolution& done) {
  const auto& residual = done.residual;
  fmt::print("contacts            {} between {} bodies\n", solved.problem.contacts.size(),
             solved.problem.bodies.size());
  fmt::print("sweeps              {}, forward and backward\n", done.solution.sweeps);
  fmt::print("contact-iterations  {:.4g}\n", ContactSolution::contact_iterations(solved, done.solution));
  fmt::print("solver CPU time     {:.4g} s\n", done.cpu_seconds);
  fmt::print("residual            {:.3g} g dt: normal {:.3g}, tangential {:.3g}, rolling {:.3g}\n", residual.worst(),
             residual.normal, residual.tangential, residual.rolling);
}

int act(const SolveOptions& options) {
  auto posed = read_contact_problem(options.file);
  check_out(options);
  auto settings = options.settings;
  settings.accelerated = options.solver == "accelerated";
  const auto done = solve(posed, settings, options.warm);
  if (!options.out.empty()) write_contact_solution(options.out, posed, done);
  if (!options.quiet) describe(posed, done);
  if (!done.solution.converged) {
    fmt::print(stderr, "{}: the tolerance of {:g} was not reached in {} sweeps: the residual is {:.3g}\n", options.file,
               settings.tolerance, done.solution.sweeps, done.residual.worst());
  }
  return 0;
}

}  // namespace

Command add_solve(CLI::App& app) {
  auto options = std::make_shared<SolveOptions>();
  auto& settings = options->settings;
  auto* command = app.add_subcommand("solve", "Solve a contact problem that `export --to contact-problem` wrote");
  command->add_option("FILE", options->file, "The problem, an HDF5 file")->required();
  command->add_option("--out", options->out, "File to write impulses and velocities to (default: none)");
  command->add_option("--tolerance", settings.tolerance, "Largest residual velocity of a contact, in units of g dt")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--most-sweeps", settings.most_sweeps, "Forward and backward sweeps at most")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--solver", options->solver, "accelerated, or sweeps alone")
      ->check(CLI::IsMember({"accelerated", "sweeps"}))
      ->capture_default_str();
  command->add_flag("--warm", options->warm, "Start from the impulses of the file, not from none");
  command->add_flag("--overwrite", options->overwrite, "Replace the file --out");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
