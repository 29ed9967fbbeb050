// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/scene_options.hpp"

#include <CLI/CLI.hpp>

namespace repose {

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("SCENE", file, "Scene file (TOML)")->required();
  command.add_option("--set", overrides.set, "KEY=VALUE: override a key of the scene, e.g. contact.friction=0.3")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option_function<std::int64_t>(
      "--seed", [this](const std::int64_t& seed) { overrides.seed = seed; }, "Seed of everything random");
}

}  // namespace repose
