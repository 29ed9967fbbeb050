// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace repose {

namespace {

constexpr std::size_t line_width = 80;

/// The words of a text in lines that begin with `indent` spaces; the first line continues after `column` characters.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t column = 0) {
  std::istringstream words(text);
  std::string lines;
  bool first_word = true;
  if (column < indent) lines.append(indent - column, ' ');
  column = std::max(column, indent);
  for (std::string word; words >> word; first_word = false) {
    if (!first_word && column + 1 + word.size() > line_width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first_word) {
      lines += " ";
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines + "\n";
}

std::string paragraphs(const std::string& text) {
  std::string result;
  std::size_t start = 0;
  while (start < text.size()) {
    const auto end = std::min(text.find("\n\n", start), text.size());
    result += "\n" + wrapped(text.substr(start, end - start), 0);
    start = end + 2;
  }
  return result;
}

using Row = std::pair<std::string, std::string>;

std::string rows(const std::string& title, const std::vector<Row>& all) {
  if (all.empty()) return "";
  std::size_t width = 0;
  for (const auto& row : all) width = std::max(width, row.first.size());
  std::string text = "\n" + title + "\n";
  for (const auto& [name, about] : all) {
    const auto start = fmt::format("  {:{}}  ", name, width);
    text += start + wrapped(about, start.size(), start.size());
  }
  return text;
}

std::string argument_rows(const Verb& verb) {
  std::vector<Row> positional;
  std::vector<Row> options;
  for (const auto& argument : verb.arguments) {
    (argument.is_option() ? options : positional).emplace_back(written(argument), meaning(argument));
  }
  options.emplace_back("--help", "Print this help");
  return rows("Arguments", positional) + rows("Options", options);
}

std::string example_text(const Verb& verb) {
  std::string text = "\nExamples\n";
  for (const auto& example : verb.examples) {
    text += fmt::format("  {}\n", example.command) + wrapped(example.about, 6);
  }
  return text;
}

}  // namespace

std::string written(const Argument& argument) {
  return argument.value.empty() ? argument.name : argument.name + " " + argument.value;
}

std::string meaning(const Argument& argument) {
  std::string text = argument.about;
  if (!argument.choices.empty()) text += fmt::format(": {}", fmt::join(argument.choices, ", "));
  if (argument.repeats()) text += "; may be repeated";
  if (argument.shows_default) text += fmt::format(" (default: {})", held_value(argument));
  return text;
}

std::string usage(const Program& program, const Verb& verb) {
  std::string text = program.itself.name + " " + verb.name;
  for (const auto& argument : verb.arguments) {
    if (!argument.is_option()) text += argument.required ? " " + argument.name : " [" + argument.name + "]";
  }
  for (const auto& argument : verb.arguments) {
    if (argument.is_option() && argument.required) text += " " + written(argument);
  }
  return text + " [options]";
}

std::string help_text(const Program& program) {
  const auto& itself = program.itself;
  std::vector<Row> verbs;
  for (const auto& verb : program.verbs) verbs.emplace_back(verb.name, verb.about);
  return fmt::format("{0} - {1}\n\nUsage: {0} VERB [arguments]\n", itself.name, itself.about) + rows("Verbs", verbs) +
         argument_rows(itself) + example_text(itself) + paragraphs(itself.details);
}

std::string help_text(const Program& program, const Verb& verb) {
  return wrapped(verb.about, 0) + fmt::format("\nUsage: {}\n", usage(program, verb)) + paragraphs(verb.details) +
         argument_rows(verb) + example_text(verb);
}

}  // namespace repose
