// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/run_folder/further_analysis.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/toml_file.hpp"
#include "repose/sweep/folder.hpp"

#include <memory>
#include <string>

namespace repose {

namespace {

struct AnalyseOptions {
  std::string folder;
  FurtherAnalysis further;
  bool quiet = false;
};

int act(const AnalyseOptions& options) {
  if (SweepFolder::is_one(options.folder)) {
    SweepFolder sweep(options.folder);
    const auto members = sweep.analyse(options.further);
    if (!options.quiet) say("analysed         {} members; wrote the tables of {}\n", members, options.folder);
    return 0;
  }
  const FolderLock lock(options.folder);
  if (read_run_scene(options.folder) != text_of_file(options.folder + "/scene.toml")) {
    complain("{}/scene.toml: has changed since the run; the analysis uses its [analysis] as it stands now\n",
             options.folder);
  }
  with_dimension(run_dimension(options.folder), [&](auto dimension) {
    const auto record = read_record<dimension>(options.folder);
    const auto results = analyse(record, options.further);
    write_results(options.folder, lock, record, results);
    if (!options.quiet) say("{}", describe_result(record, results));
  });
  return 0;
}

}  // namespace

Verb analyse_verb() {
  auto options = std::make_shared<AnalyseOptions>();
  return {
      .name = "analyse",
      .about = "Repeat the analysis of a run, or of a sweep and all its members",
      .details =
          "Writes analysis.h5 and summary.json, or the tables of the sweep; the run itself stays as it is. "
          "The settings are those of [analysis] in DIR/scene.toml, which may be edited.",
      .arguments = {folder_argument(options->folder, "Run folder or sweep folder"),
                    {.name = "--force-range",
                     .about = "Also find which base forces equilibrium allows at the places of rigid grains",
                     .target = &options->further.force_range},
                    {.name = "--stability",
                     .about = "Also find the smallest eigenvalue of the stiffness matrix of grains at rest",
                     .target = &options->further.stability},
                    {.name = "--slips",
                     .about = "Also find stick and slip of a driven wall, and the distribution of its force drops",
                     .target = &options->further.slips},
                    quiet_argument(options->quiet)},
      .examples = {{"repose analyse heap", "Analyse the run in the folder heap again"},
                   {"repose run examples/heap-cd.toml --out rigid-heap", "Pour a heap of rigid grains"},
                   {"repose analyse rigid-heap --force-range", "Find how far statics decides the forces on its base"}},
      .act = [options] { return act(*options); }};
}

}  // namespace repose
