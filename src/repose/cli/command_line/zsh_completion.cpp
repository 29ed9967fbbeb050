// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace repose {

namespace {

/// Text within single quotes and square brackets of a specification of _arguments.
std::string for_zsh(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\'') {
      result += "'\\''";
    } else {
      if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') result += '\\';
      result += letter;
    }
  }
  return result;
}

std::string zsh_candidates(const Argument& argument) {
  if (!argument.choices.empty()) return fmt::format("({})", fmt::join(argument.choices, " "));
  if (argument.suggestions) return fmt::format("({})", fmt::join(argument.suggestions(), " "));
  switch (argument.completes) {
    case Completion::scene_files:
      return "_files -g \"*.toml\"";
    case Completion::files:
      return "_files";
    case Completion::folders:
      return "_files -/";
    case Completion::nothing:
      break;
  }
  return "";
}

std::string specification(const Argument& argument) {
  const auto about = for_zsh(argument.about);
  if (argument.is_flag()) return fmt::format("'{}[{}]'", argument.name, about);
  if (!argument.is_option()) return fmt::format("':{}:{}'", argument.name, zsh_candidates(argument));
  return fmt::format("'{}{}[{}]:{}:{}'", argument.repeats() ? "*" : "", argument.name, about, for_zsh(argument.value),
                     zsh_candidates(argument));
}

std::string specifications(const Verb& verb, const std::string& indent) {
  std::string text;
  for (const auto& argument : verb.arguments) text += fmt::format(" \\\n{}{}", indent, specification(argument));
  return text + fmt::format(" \\\n{}'--help[Print this help]'", indent);
}

}  // namespace

std::string zsh_completion(const Program& program) {
  std::string text = "#compdef repose\n\n_repose() {\n  local context state state_descr line\n  typeset -A opt_args\n";
  text += "  local -a verbs=(\n";
  for (const auto& verb : program.verbs) text += fmt::format("    '{}:{}'\n", verb.name, for_zsh(verb.about));
  text += "  )\n  _arguments -C" + specifications(program.itself, "    ");
  text += " \\\n    '1:verb:->verb' '*::argument:->arguments'\n";
  text += "  case $state in\n    verb) _describe verb verbs ;;\n    arguments)\n      case $line[1] in\n";
  for (const auto& verb : program.verbs) {
    text += fmt::format("        {}) _arguments{} ;;\n", verb.name, specifications(verb, "          "));
  }
  return text + "      esac ;;\n  esac\n}\n\n_repose \"$@\"\n";
}

}  // namespace repose
