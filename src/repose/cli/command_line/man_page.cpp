// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/help.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace repose {

namespace {

/// Text for troff: hyphens stay hyphens that can be copied, and no line of text is read as a request.
std::string for_man(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\\') {
      result += "\\e";
    } else if (letter == '-') {
      result += "\\-";
    } else {
      result += letter;
    }
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string man_paragraphs(std::string text) {
  if (text.empty()) return "";
  for (std::size_t at = 0; (at = text.find("\n\n", at)) != std::string::npos;) text.replace(at, 2, "\n.PP\n");
  std::string result = ".PP\n";
  for (std::size_t start = 0; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const auto line = text.substr(start, end - start);
    result += (line == ".PP" ? line : for_man(line)) + "\n";
    start = end + 1;
  }
  return result;
}

std::string arguments(const Verb& verb) {
  std::string text;
  for (const auto& argument : verb.arguments) {
    text += fmt::format(".TP\n.B {}\n{}.\n", for_man(written(argument)), for_man(meaning(argument)));
  }
  return text;
}

std::string examples(const Verb& verb) {
  std::string text;
  for (const auto& example : verb.examples) {
    text += fmt::format(".PP\n{}:\n.PP\n.in +4\n.EX\n{}\n.EE\n.in\n", for_man(example.about), for_man(example.command));
  }
  return text;
}

}  // namespace

std::string man_page(const Program& program, const std::string& version) {
  const auto& itself = program.itself;
  std::string text = fmt::format(".TH REPOSE 1 \"\" \"repose {}\" \"User commands\"\n", version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", itself.name, for_man(itself.about));
  text += ".SH SYNOPSIS\n";
  for (const auto& verb : program.verbs) {
    text += fmt::format(".B {}\n.br\n", for_man(usage(program, verb)));
  }
  text += ".SH DESCRIPTION\n" + man_paragraphs(itself.details);
  text += ".SH OPTIONS\n" + arguments(itself) + ".TP\n.B \\-\\-help\nPrint the help of the program, or of a verb.\n";
  text += ".SH VERBS\n";
  for (const auto& verb : program.verbs) {
    text += fmt::format(".SS {}\n{}.\n", for_man(usage(program, verb)), for_man(verb.about));
    text += man_paragraphs(verb.details) + arguments(verb) + examples(verb);
  }
  return text + ".SH EXAMPLES\n" + examples(itself);
}

}  // namespace repose
