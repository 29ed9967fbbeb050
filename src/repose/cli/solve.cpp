// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/contact_problem/contact_solution.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/io/named_file.hpp"

#include <fmt/format.h>

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
  if (!path_exists(options.out)) return;
  if (std::filesystem::equivalent(options.out, options.file, error)) {
    throw InputError(fmt::format("{}: is the problem itself; choose another --out", options.out));
  }
  if (!options.overwrite || !std::filesystem::is_regular_file(options.out, error)) {
    throw InputError(fmt::format("{}: already exists; choose another --out, or --overwrite a file", options.out));
  }
}

void report(const ContactProblem& solved, const ContactSolution& done) {
  const auto& residual = done.residual;
  say("contacts            {} between {} bodies\n", solved.problem.contacts.size(), solved.problem.bodies.size());
  say("sweeps              {}, forward and backward\n", done.solution.sweeps);
  say("contact-iterations  {:.4g}\n", ContactSolution::contact_iterations(solved, done.solution));
  say("solver CPU time     {:.4g} s\n", done.cpu_seconds);
  say("residual            {:.3g} g dt: normal {:.3g}, tangential {:.3g}, rolling {:.3g}\n", residual.worst(),
      residual.normal, residual.tangential, residual.rolling);
}

int act(const SolveOptions& options) {
  auto posed = read_contact_problem(options.file);
  check_out(options);
  auto settings = options.settings;
  settings.accelerated = options.solver == "accelerated";
  const auto done = solve(posed, settings, options.warm);
  if (!options.out.empty()) write_contact_solution(followed(options.out), posed, done);
  if (!options.quiet) report(posed, done);
  if (!done.solution.converged) {
    complain("{}: the tolerance of {:g} was not reached in {} sweeps: the residual is {:.3g}\n", options.file,
             settings.tolerance, done.solution.sweeps, done.residual.worst());
  }
  return 0;
}

}  // namespace

Verb solve_verb() {
  auto options = std::make_shared<SolveOptions>();
  auto& settings = options->settings;
  return {.name = "solve",
          .about = "Solve a contact problem of contact dynamics and report its residual",
          .details = "`repose export --to contact-problem` writes such a file.",
          .arguments = {{.name = "FILE",
                         .about = "Contact problem (HDF5)",
                         .target = &options->file,
                         .required = true,
                         .completes = Completion::files},
                        {.name = "--out",
                         .value = "FILE",
                         .about = "File to write with the impulses and velocities (default: none)",
                         .target = &options->out,
                         .completes = Completion::files},
                        {.name = "--tolerance",
                         .value = "X",
                         .about = "Largest residual velocity of a contact, in units of g dt",
                         .target = &settings.tolerance,
                         .shows_default = true,
                         .bound = {.least = 0}},
                        {.name = "--most-sweeps",
                         .value = "N",
                         .about = "Most sweeps, each forward and backward",
                         .target = &settings.most_sweeps,
                         .shows_default = true,
                         .bound = {.least = 0}},
                        {.name = "--solver",
                         .value = "SOLVER",
                         .about = "Accelerated sweeps, or sweeps alone",
                         .target = &options->solver,
                         .shows_default = true,
                         .choices = {"accelerated", "sweeps"}},
                        {.name = "--warm",
                         .about = "Start from the impulses of the file instead of zero",
                         .target = &options->warm},
                        overwrite_argument(options->overwrite, "Replace the file that --out names"),
                        quiet_argument(options->quiet)},
          .examples = {{"repose run examples/heap-cd.toml --out rigid", "Pour a heap of rigid grains"},
                       {"repose export rigid --to contact-problem", "Write its next step as a contact problem"},
                       {"repose solve rigid/export/contact-problem/problem.h5 --tolerance 1e-9",
                        "Solve that step more precisely than the run did"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
