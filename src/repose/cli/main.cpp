// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/parse.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

namespace {

int report(const std::exception& failure, int status) {
  fmt::print(stderr, "{}\n", failure.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace repose;
  // A full disk is reported by the write that fails, not by a signal that kills the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const auto program = repose_program();
  const auto [verb, status] = parse(program, argc, argv, exit_bad_input);
  if (verb == nullptr) return status;
  try {
    return verb->act();
  } catch (const InputError& error) {
    return report(error, exit_bad_input);
  } catch (const std::exception& error) {
    return report(error, exit_run_trouble);
  }
}
