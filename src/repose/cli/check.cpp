// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/scene_options.hpp"
#include "repose/simulation/expectation.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace repose {

Command add_check(CLI::App& app) {
  auto options = std::make_shared<SceneOptions>();
  auto* command = app.add_subcommand("check", "Read and validate a scene; say what would run");
  options->add_to(*command);
  return {command, [options] {
            const auto scene = options->read();
            const auto traits = scene.method->traits();
            fmt::print("{}{}", describe(scene), traits.force_laws ? describe_contacts(scene) : "");
            const double work = expected_work(scene, expected_end(scene));
            fmt::print("cost             about {:.2g} s of one core\n", work / traits.typical_speed);
            return 0;
          }};
}

}  // namespace repose
