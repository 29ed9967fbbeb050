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

namespace {

/// Grain-steps per second of one core, for a rough estimate only; `./dev bench` measures the machine at hand.
constexpr double typical_speed = 1e7;
constexpr double typical_discs = 2e6;  ///< deposited per second
constexpr double typical_rigid = 1e5;  ///< grain-steps of contact dynamics; ten times that where all is at rest

double typical_rate(const Scene& scene) {
  if (scene.method.deposits()) return typical_discs;
  return scene.method.rigid() ? typical_rigid : typical_speed;
}

}  // namespace

Command add_check(CLI::App& app) {
  auto options = std::make_shared<SceneOptions>();
  auto* command = app.add_subcommand("check", "Read and validate a scene; say what would run");
  options->add_to(*command);
  return {command, [options] {
            const auto scene = options->read();
            const bool forces = !scene.method.deposits() && !scene.method.rigid();
            fmt::print("{}{}", describe(scene), forces ? describe_contacts(scene) : "");
            const double work = expected_work(scene, expected_end(scene));
            fmt::print("cost             about {:.2g} s of one core\n", work / typical_rate(scene));
            return 0;
          }};
}

}  // namespace repose
