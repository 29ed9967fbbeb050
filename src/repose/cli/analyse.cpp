// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/describe.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/sweep/folder.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

namespace repose {

namespace {

struct AnalyseOptions {
  std::string folder;
  bool quiet = false;
};

int act(const AnalyseOptions& options) {
  if (SweepFolder::is_one(options.folder)) {
    SweepFolder sweep(options.folder);
    const auto members = sweep.analyse();
    if (!options.quiet) fmt::print("analysed         {} members; wrote the tables of {}\n", members, options.folder);
    return 0;
  }
  const FolderLock lock(options.folder);
  const auto record = read_record(options.folder);
  if (read_run_scene(options.folder) != text_of_file(options.folder + "/scene.toml")) {
    fmt::print(stderr, "{}/scene.toml: was changed since the run; its [analysis] is taken as it is now\n",
               options.folder);
  }
  const auto results = analyse(record);
  write_results(options.folder, record, results);
  if (!options.quiet) fmt::print("{}", describe_result(record, results));
  return 0;
}

}  // namespace

Command add_analyse(CLI::App& app) {
  auto options = std::make_shared<AnalyseOptions>();
  auto* command = app.add_subcommand(
      "analyse",
      "Work out anew what the analysis says of a run, or of a sweep and all its members; the run stays as it is");
  command->add_option("DIR", options->folder, "Run folder or sweep folder")->required();
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  return {command, [options] { return act(*options); }};
}

}  // namespace repose
