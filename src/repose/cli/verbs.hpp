// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/cli/command_line/verb.hpp"

namespace repose {

inline constexpr int exit_run_trouble = 1;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_interrupted = 130;

// The verbs in the order of the help. A verb is one file, which defines NAME_verb(), and its line here.
// clang-format off
#define REPOSE_VERBS(verb) \
  verb(scene) \
  verb(check) \
  verb(run) \
  verb(resume) \
  verb(sweep) \
  verb(calibrate) \
  verb(study) \
  verb(analyse) \
  verb(plot) \
  verb(view) \
  verb(theory) \
  verb(export) \
  verb(solve) \
  verb(reference)
// clang-format on

#define REPOSE_DECLARE_VERB(name) Verb name##_verb();
REPOSE_VERBS(REPOSE_DECLARE_VERB)
#undef REPOSE_DECLARE_VERB

/// The program with all verbs.
Program repose_program();

}  // namespace repose
