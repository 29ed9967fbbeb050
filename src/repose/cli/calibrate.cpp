// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/python.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

namespace fs = std::filesystem;

struct CalibrateOptions {
  std::string file;
  std::string out;
  int processes = 0;
  std::string part;     // I/N
  double lease = 60.0;  // [s]
  bool overwrite = false;
  bool dry = false;
  bool quiet = false;
};

/// This program, which the calibration calls for its sweeps.
std::string own_path() {
  std::error_code error;
  const auto path = fs::read_symlink("/proc/self/exe", error);
  if (error) throw RunError(fmt::format("/proc/self/exe: cannot be read: {}", error.message()));
  return path.string();
}

int act(const CalibrateOptions& options) {
  if (!options.part.empty() && options.overwrite) {
    throw InputError("--overwrite: one of several that share a calibration cannot remove it");
  }
  const auto folder = options.out.empty() ? fs::path(options.file).stem().string() : options.out;
  std::vector<std::string> words = {own_path(), options.file, folder};
  if (options.processes > 0) words.insert(words.end(), {"--threads", fmt::format("{}", options.processes)});
  if (!options.part.empty()) {
    words.insert(words.end(), {"--share", options.part, "--lease", fmt::format("{}", options.lease)});
  }
  if (options.overwrite) words.emplace_back("--overwrite");
  if (options.dry) words.emplace_back("--check");
  if (options.quiet) words.emplace_back("--quiet");
  hand_over_to_python("repose.calibrate", words);
}

}  // namespace

Verb calibrate_verb() {
  auto options = std::make_shared<CalibrateOptions>();
  return {.name = "calibrate",
          .about = "Find the parameters of a scene that give measured targets",
          .details =
              "Runs sweeps in rounds, fits a Gaussian process to each target, and writes the posterior of the "
              "parameters with its pictures. The same command continues a calibration after a stop of any kind.",
          .arguments = {{.name = "CALIBRATION",
                         .about = "Calibration file (TOML)",
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
                        {.name = "--share",
                         .value = "I/N",
                         .about = "Be part I of N programs that share the calibration, here or on other machines",
                         .target = &options->part},
                        {.name = "--lease",
                         .value = "SECONDS",
                         .about = "With --share: a program that has not stirred for so long is dead; its members are "
                                  "taken over (60)",
                         .target = &options->lease,
                         .bound = {.least = 1, .most = 86400}},
                        overwrite_argument(options->overwrite, "Remove a calibration that the folder already holds"),
                        {.name = "--check",
                         .about = "Check the calibration and describe its first points, without running",
                         .target = &options->dry},
                        quiet_argument(options->quiet)},
          .examples = {{"repose calibrate examples/calibrations/angle.toml --check", "Say what would run first"},
                       {"repose calibrate examples/calibrations/angle.toml --out angle",
                        "Find the frictions that give an angle of repose; repeat the command to continue"},
                       {"repose calibrate examples/calibrations/angle.toml --out angle --share 1/2",
                        "The same as one of two programs, here or on two machines"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
