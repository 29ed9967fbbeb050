// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/command_line/help.hpp"
#include "repose/cli/say.hpp"
#include "repose/cli/verbs.hpp"
#include "repose/core/version.hpp"

#include <memory>

namespace repose {

namespace {

struct ProgramOptions {
  bool version = false;
  bool man = false;
  std::string completion;
};

std::vector<Verb> all_verbs() {
  std::vector<Verb> verbs;
#define REPOSE_ADD_VERB(name) verbs.push_back(name##_verb());
  REPOSE_VERBS(REPOSE_ADD_VERB)
#undef REPOSE_ADD_VERB
  return verbs;
}

int act(const ProgramOptions& options) {
  if (options.version) {
    say("{}\n", version);
  } else if (options.man) {
    say("{}", man_page(repose_program(), version));
  } else if (options.completion == "bash") {
    say("{}", bash_completion(repose_program()));
  } else if (options.completion == "zsh") {
    say("{}", zsh_completion(repose_program()));
  } else {
    complain("{}", help_text(repose_program()));
    return exit_bad_input;
  }
  return 0;
}

constexpr const char* details =
    "`repose VERB --help` explains a verb. The scenes below examples/ lie in the folder of the source and in "
    "share/repose of an installation.\n\n"
    "Exit status: 0 if all is well, 1 after trouble in a run, 2 after bad input, 130 after Ctrl-C or SIGTERM, which "
    "leave a folder that `repose resume` or `repose sweep` continues.\n\n"
    "Environment: REPOSE_PYTHON names the Python that draws (default: /usr/bin/python3), REPOSE_PYTHON_PATH the folder "
    "of the Python package, where it is not the one installed with the program.";

}  // namespace

Program repose_program() {
  auto options = std::make_shared<ProgramOptions>();
  return {.itself = {.name = "repose",
                     .about = "an open laboratory for the mechanics of granular heaps, packings and columns",
                     .details = details,
                     .arguments = {{.name = "--version", .about = "Print the version", .target = &options->version},
                                   {.name = "--man", .about = "Print the manual page", .target = &options->man},
                                   {.name = "--completion",
                                    .value = "SHELL",
                                    .about = "Print the script that completes command lines in a shell",
                                    .target = &options->completion,
                                    .choices = {"bash", "zsh"}}},
                     .examples = {{"repose check examples/heap.toml", "Say what a scene would run, and at what cost"},
                                  {"repose run examples/heap.toml --out heap", "Pour a heap and write the folder heap"},
                                  {"repose plot heap", "Draw it into heap/pictures"},
                                  {"repose theory pile-continuum --plot theory.png", "Draw a stress model"}},
                     .act = [options] { return act(*options); }},
          .verbs = all_verbs()};
}

}  // namespace repose
