// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/cli/python.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace repose {

Command add_plot(CLI::App& app) {
  auto arguments = std::make_shared<std::vector<std::string>>();
  auto folder = std::make_shared<std::string>();
  auto* command = app.add_subcommand("plot", "Draw the standard pictures of a run folder or a sweep");
  command->add_option("DIR", *folder, "Run folder or sweep folder")->required();
  const auto pass_on = [&](const std::string& option, const std::string& about) {
    command->add_option_function<std::string>(
        option,
        [arguments, option](const std::string& value) {
          arguments->push_back(option);
          arguments->push_back(value);
        },
        about);
  };
  pass_on("--only", "Pictures to draw; a wrong name lists them");
  pass_on("--format", "png,svg");
  pass_on("--dpi", "Resolution of PNG");
  pass_on("--frame", "A saved frame instead of the last state");
  return {command, [arguments, folder]() -> int {
            arguments->insert(arguments->begin(), *folder);
            hand_over_to_python("repose.plot", *arguments);
          }};
}

}  // namespace repose
