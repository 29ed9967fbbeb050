// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/parse.hpp"

#include "repose/cli/command_line/help.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace repose {

namespace {

void add(CLI::App& app, const Argument& argument) {
  const auto store_all = [&argument](const std::vector<std::string>& texts) {
    if (texts.size() > 1 && !argument.repeats()) throw CLI::ValidationError(argument.name, "is given more than once");
    for (const auto& text : texts) {
      const auto problem = store(argument, text);
      if (!problem.empty()) throw CLI::ValidationError(argument.name, fmt::format("{}, is \"{}\"", problem, text));
    }
  };
  if (argument.is_flag()) {
    app.add_flag(argument.name, *std::get<bool*>(argument.target), argument.about);
    return;
  }
  auto* option = app.add_option_function<std::vector<std::string>>(argument.name, store_all, argument.about);
  option->required(argument.required)->expected(1)->allow_extra_args(false);
  if (argument.is_option()) {
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  } else if (argument.repeats()) {
    constexpr int most_words = 1'000'000;
    option->expected(1, most_words)->allow_extra_args(true);
  }
}

std::string problem(const CLI::Error& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  return text.substr(0, text.find(':')) + ": needs a value";
}

void describe(CLI::App& app, const Verb& verb, const std::string& help) {
  app.formatter_fn([help](const CLI::App*, const std::string&, CLI::AppFormatMode) { return help; });
  for (const auto& argument : verb.arguments) add(app, argument);
}

}  // namespace

Parsed parse(const Program& program, int argc, const char* const* argv, int bad_status) {
  CLI::App app;
  describe(app, program.itself, help_text(program));
  app.require_subcommand(0, 1);
  std::vector<CLI::App*> apps;
  for (const auto& verb : program.verbs) {
    apps.push_back(app.add_subcommand(verb.name, verb.about));
    describe(*apps.back(), verb, help_text(program, verb));
  }
  app.failure_message([&](const CLI::App*, const CLI::Error& error) {
    std::string command = program.itself.name;
    for (std::size_t k = 0; k < apps.size(); ++k) {
      if (apps[k]->parsed()) command += " " + program.verbs[k].name;
    }
    return fmt::format("{0}: {1} (`{0} --help` shows how to call it)\n", command, problem(error));
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return {.status = app.exit(error) == 0 ? 0 : bad_status};
  }
  for (std::size_t k = 0; k < apps.size(); ++k) {
    if (apps[k]->parsed()) return {.verb = &program.verbs[k]};
  }
  return {.verb = &program.itself};
}

}  // namespace repose
