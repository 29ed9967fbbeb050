// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/parse.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/surroundings.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/errors.hpp"
#include "repose/core/failure.hpp"
#include "repose/core/instruction_set.hpp"

#include <exception>

namespace {

/// Carries out a command line and returns its exit status. No exception passes.
int carry_out(int argc, char** argv) {
  using namespace repose;
  try {
    chosen_instruction_set();  // a wrong name is an error before anything is done
    const auto program = repose_program();
    const auto [verb, status] = parse(program, argc, argv, exit_bad_input);
    return verb == nullptr ? status : verb->act();
  } catch (const InputError& error) {
    complain("{}\n", error.what());
    return exit_bad_input;
  } catch (const std::exception& failure) {
    complain("{}\n", message_of(failure));
    return exit_run_trouble;
  }
}

}  // namespace

int main(int argc, char** argv) {
  repose::settle_in();
  return repose::status_after_output(carry_out(argc, argv));
}
