// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/describe.hpp"
#include "repose/cli/scene_options.hpp"
#include "repose/run/expectation.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace repose {

namespace {

/// Grain-steps per second of one core, for a rough estimate only; `./dev bench` measures the machine at hand.
constexpr double typical_speed = 1e7;
constexpr double typical_discs = 2e6;  ///< deposited per second

}  // namespace

Command add_check(CLI::App& app) {
  auto options = std::make_shared<SceneOptions>();
  auto* command = app.add_subcommand("check", "Read and validate a scene; say what would run");
  options->add_to(*command);
  return {command, [options] {
            const auto scene = options->read();
            const bool deposits = scene.method.deposits();
            fmt::print("{}{}", describe(scene), deposits ? "" : describe_contacts(scene));
            const double work = expected_work(scene, expected_end(scene));
            fmt::print("cost             about {:.2g} s of one core\n",
                       work / (deposits ? typical_discs : typical_speed));
            return 0;
          }};
}

}  // namespace repose
