// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace repose {

/// The variable that an argument sets. A bool makes the argument a flag; a list lets it be repeated.
using Target = std::variant<bool*, int*, std::int64_t*, double*, std::string*, std::optional<std::string>*,
                            std::optional<std::int64_t>*, std::vector<std::string>*>;

/// What a shell completes an argument with, apart from the words of `choices` and `suggestions`.
enum class Completion { nothing, scene_files, files, folders };

/// Bounds of a number, both allowed.
struct Bound {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// One argument of a verb. The parser, the help, the man page and the shell completion all read this description.
struct Argument {
  std::string name{};   ///< "--out"; without dashes it is positional: "SCENE"
  std::string value{};  ///< the word that stands for the value of an option: "DIR"
  std::string about{};
  Target target{};
  bool required = false;
  bool shows_default = false;                               ///< the help adds what the target holds before parsing
  Bound bound{};                                            ///< of a number
  std::vector<std::string> choices{};                       ///< words allowed; empty: all
  std::function<std::vector<std::string>()> suggestions{};  ///< words that a shell offers; others are allowed
  Completion completes = Completion::nothing;

  bool is_option() const { return name.starts_with("--"); }
  bool is_flag() const { return std::holds_alternative<bool*>(target); }
  bool repeats() const { return std::holds_alternative<std::vector<std::string>*>(target); }
};

struct Example {
  std::string command{};  ///< a complete command line; files that it names below examples/ exist
  std::string about{};
};

/// One verb of the program. `act` is called after parsing and returns the exit status.
struct Verb {
  std::string name{};
  std::string about{};    ///< one line without a full stop
  std::string details{};  ///< paragraphs, separated by empty lines; may be empty
  std::vector<Argument> arguments{};
  std::vector<Example> examples{};
  std::function<int()> act{};
};

/// The program: what holds without a verb, and its verbs.
struct Program {
  Verb itself{};
  std::vector<Verb> verbs{};
};

/// Stores one written value in the target of an argument. Returns what is wrong with it, "" if nothing.
std::string store(const Argument& argument, const std::string& text);

/// What the target holds, as help shows it.
std::string held_value(const Argument& argument);

}  // namespace repose
