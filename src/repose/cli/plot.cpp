// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/commands.hpp"
#include "repose/core/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace repose {

namespace {

std::string from_environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

/// Hands over to the Python package, which draws; only returns by throwing.
[[noreturn]] void draw(std::vector<std::string> arguments) {
  const auto python = from_environment("REPOSE_PYTHON", "/usr/bin/python3");
  const auto package = from_environment("REPOSE_PYTHON_PATH", REPOSE_PYTHON_PATH);
  const auto old_path = from_environment("PYTHONPATH", "");
  ::setenv("PYTHONPATH", (old_path.empty() ? package : package + ":" + old_path).c_str(), 1);
  std::vector<std::string> words = {python, "-m", "repose.plot"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(python.c_str(), pointers.data());
  throw RunError(
      fmt::format("{}: cannot start Python: {} (REPOSE_PYTHON names another)", python, std::strerror(errno)));
}

}  // namespace

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
            draw(*arguments);
          }};
}

}  // namespace repose
