// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/carry_out.hpp"
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/simulation/expectation.hpp"

#include <memory>

namespace repose {

namespace {

int act(const SceneOptions& options) {
  const auto scene = options.read();
  const auto traits = scene.method->traits();
  say("{}{}", describe(scene), traits.force_laws ? describe_contacts(scene) : "");
  for (const auto& warning : scene.start.warnings) say("warning          {}\n", warning);
  const double work = expected_work(scene, expected_end(scene));
  say("cost             about {:.2g} s of one core, {:.2g} GB of memory\n", work / expected_speed(scene),
      expected_memory(scene) / 1e9);
  check_memory(scene, options.file);
  return 0;
}

}  // namespace

Verb check_verb() {
  auto options = std::make_shared<SceneOptions>();
  return {.name = "check",
          .about = "Check a scene and describe the run: grains, laws, time step, expected cost",
          .details = "Every problem of the scene is listed, with its line in the file. Nothing is written.",
          .arguments = {scene_argument(*options), set_argument(*options), seed_argument(*options)},
          .examples = {{"repose check examples/heap.toml", "Describe the heap"},
                       {"repose check examples/heap.toml --set method.time_step=0.0005",
                        "See what a smaller time step costs"}},
          .act = [options] { return act(*options); }};
}

}  // namespace repose
