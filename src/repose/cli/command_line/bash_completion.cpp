// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace repose {

namespace {

/// The shell command that prints what an argument may be.
std::string candidates(const Argument& argument) {
  if (!argument.choices.empty()) return fmt::format("_repose_words '{}'", fmt::join(argument.choices, " "));
  if (argument.suggestions) return fmt::format("_repose_words '{}'", fmt::join(argument.suggestions(), " "));
  switch (argument.completes) {
    case Completion::scene_files:
      return "_repose_scenes";
    case Completion::files:
      return "_repose_files";
    case Completion::folders:
      return "_repose_folders";
    case Completion::nothing:
      break;
  }
  return ":";
}

std::string options(const Verb& verb) {
  std::string text = "--help";
  for (const auto& argument : verb.arguments) {
    if (argument.is_option()) text += " " + argument.name;
  }
  return text;
}

/// Cases of `verb:option` for the values of options, then of `verb:` for everything else.
std::string cases(const Verb& verb, const std::string& name) {
  std::string text;
  for (const auto& argument : verb.arguments) {
    if (!argument.is_option() || argument.is_flag()) continue;
    text += fmt::format("    {}:{}) {} ;;\n", name, argument.name, candidates(argument));
  }
  text += fmt::format("    {}:*)\n      if [[ $word == -* ]]; then\n        _repose_words '{}'\n", name, options(verb));
  std::vector<const Argument*> words;
  for (const auto& argument : verb.arguments) {
    if (!argument.is_option()) words.push_back(&argument);
  }
  constexpr std::size_t first = 2;  // the word after the verb
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto begin = k + 1 < words.size() ? fmt::format("elif ((COMP_CWORD == {})); then", first + k) : "else";
    text += fmt::format("      {}\n        {}\n", begin, candidates(*words[k]));
  }
  return text + "      fi\n      ;;\n";
}

constexpr const char* head = R"(# bash completion of repose

_repose_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_repose_files() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$word"); }
_repose_folders() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$word"); }
_repose_scenes() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.toml' -- "$word")
}

_repose() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb=""
  if ((COMP_CWORD > 1)); then verb=${COMP_WORDS[1]}; fi
  COMPREPLY=()
  case $verb:$before in
)";

constexpr const char* tail = R"(  esac
}

complete -F _repose repose
)";

}  // namespace

std::string bash_completion(const Program& program) {
  std::string text = head;
  std::string verbs;
  for (const auto& verb : program.verbs) {
    text += cases(verb, verb.name);
    verbs += verb.name + " ";
  }
  for (const auto& argument : program.itself.arguments) {
    if (!argument.is_flag()) text += fmt::format("    {0}:{0}) {1} ;;\n", argument.name, candidates(argument));
  }
  return text + fmt::format("    :*) _repose_words '{}{}' ;;\n", verbs, options(program.itself)) + tail;
}

}  // namespace repose
