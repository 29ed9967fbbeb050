// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/cli/viewer_process.hpp"
#include "repose/core/errors.hpp"
#include "repose/run_folder/profile.hpp"

#include <filesystem>
#include <memory>

namespace repose {

namespace {

struct RunOptions {
  SceneOptions scene;
  std::string out;
  int threads = 0;
  bool overwrite = false;
  bool beyond_memory = false;
  bool quiet = false;
  bool profile = false;
  bool view = false;
};

template <int D>
int run_scene(const Scene& scene, const std::string& out, const RunOptions& options) {
  Simulation<D> simulation(scene, threads_for(scene, options.threads));
  if (options.profile) simulation.start_profile();
  RunFolder<D> folder(out, simulation);
  if (!options.quiet) {
    say("{}", describe(scene));
    say("threads          {}\noutput           {}\n", simulation.threads(), out);
  }
  std::optional<ViewerProcess> viewer;
  if (options.view) viewer.emplace(out);
  const int status = carry_out(simulation, folder, options.quiet);
  if (options.profile) {
    folder.write_profile(simulation);
    if (!options.quiet) say_text(describe_profile(simulation));
  }
  if (viewer && status == 0) {
    say("the view stays open; Ctrl-C ends it\n");
    viewer->wait();
  }
  return status;
}

int act(const RunOptions& options) {
  const std::string out = options.out.empty() ? std::filesystem::path(options.scene.file).stem().string() : options.out;
  std::vector<std::string> problems = run_folder_problems(out, options.overwrite);
  std::optional<Scene> scene;
  try {
    scene = options.scene.read();
  } catch (const InputError& error) {
    problems.insert(problems.begin(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) throw InputError(problems);
  if (!options.beyond_memory) check_memory(*scene, options.scene.file);
  if (options.view && scene->dimension == 3) throw InputError("--view shows runs of discs alone");
  return with_dimension(scene->dimension, [&](auto dimension) { return run_scene<dimension>(*scene, out, options); });
}

}  // namespace

Verb run_verb() {
  auto options = std::make_shared<RunOptions>();
  return {.name = "run",
          .about = "Run a scene and write its run folder",
          .details =
              "Ctrl-C stops the run in good order; `repose resume` continues it to the same bits. The results do "
              "not depend on the number of threads.",
          .arguments = {scene_argument(options->scene),
                        set_argument(options->scene),
                        seed_argument(options->scene),
                        {.name = "--out",
                         .value = "DIR",
                         .about = "Folder to write (default: the name of the scene, here)",
                         .target = &options->out,
                         .completes = Completion::folders},
                        threads_argument(options->threads,
                                         "Threads, at most one per core (default: as many as have enough to do)"),
                        overwrite_argument(options->overwrite, "Replace a run that the folder already holds"),
                        {.name = "--beyond-memory",
                         .about = "Run it though it seems to need more memory than the machine has",
                         .target = &options->beyond_memory},
                        {.name = "--profile",
                         .about = "Show where the time went, stage by stage; also written to DIR/profile.json",
                         .target = &options->profile},
                        {.name = "--view",
                         .about = "Show the run in the browser while it is computed, as `repose view` does",
                         .target = &options->view},
                        quiet_argument(options->quiet)},
          .examples = {{"repose run examples/heap.toml --out heap", "Pour a heap and write the folder heap"},
                       {"repose run examples/heap.toml --out rough --seed 2 --set contact.friction=0.8",
                        "The same with another seed and more friction"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
