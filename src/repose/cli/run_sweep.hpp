// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/members.hpp"

#include <optional>
#include <string>

namespace repose {

/// A sweep to run or to continue in a folder.
struct SweepRun {
  std::string file;
  std::string folder;
  SweepForm form = SweepForm::full;
  int processes = 0;  ///< members side by side; 0: one per core
  std::optional<SweepPart> part = {};
  bool overwrite = false;
  bool quiet = false;
  bool with_result = true;  ///< shows the table and the verdicts of the sweep at the end
};

/// Runs the members that are left, shows progress and result, and writes the tables. Returns the exit status. Throws
/// InputError and RunError.
int run_sweep(const SweepRun& wanted);

/// Writes the tables of what has finished in the folder of a sweep, which others may be running. Returns the exit
/// status.
int collect_sweep(const std::string& folder, bool quiet);

}  // namespace repose
