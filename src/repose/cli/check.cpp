// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/common_arguments.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/simulation/expectation.hpp"

#include <fmt/format.h>

#include <memory>

namespace repose {

namespace {

int act(const SceneOptions& options) {
  const auto scene = options.read();
  const auto traits = scene.method->traits();
  fmt::print("{}{}", describe(scene), traits.force_laws ? describe_contacts(scene) : "");
  for (const auto& warning : scene.start.warnings) fmt::print("warning          {}\n", warning);
  const double work = expected_work(scene, expected_end(scene));
  fmt::print("cost             about {:.2g} s of one core\n", work / traits.typical_speed);
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
