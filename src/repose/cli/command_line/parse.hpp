// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/cli/command_line/verb.hpp"

namespace repose {

/// The verb that a command line asks for, with its targets set; the program itself where no verb is named. Without a
/// verb the program ends with `status`: help was printed, or what is wrong with the command line.
struct Parsed {
  const Verb* verb = nullptr;
  int status = 0;
};

/// Parses a command line. A wrong one ends with `bad_status`.
Parsed parse(const Program& program, int argc, const char* const* argv, int bad_status);

}  // namespace repose
