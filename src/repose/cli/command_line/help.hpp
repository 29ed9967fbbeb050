// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/cli/command_line/verb.hpp"

#include <string>

namespace repose {

/// "repose run SCENE [options]".
std::string usage(const Program& program, const Verb& verb);

/// "--out DIR", "--quiet" or "SCENE".
std::string written(const Argument& argument);

/// What an argument does, with its choices, its default and whether it may be repeated.
std::string meaning(const Argument& argument);

/// What `repose --help` prints.
std::string help_text(const Program& program);

/// What `repose VERB --help` prints.
std::string help_text(const Program& program, const Verb& verb);

/// The manual page repose(1), in the man macros of troff.
std::string man_page(const Program& program, const std::string& version);

/// The script by which bash, or zsh, completes command lines of the program.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);

}  // namespace repose
