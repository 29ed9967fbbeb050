// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/sweep/plan.hpp"

#include <string>

namespace repose {

/// What the command line says about Slurm.
struct SlurmOptions {
  bool wanted = false;
  int tasks = 0;  ///< 0: as many as keep their cores busy, at most four
  std::string time;
  std::string partition;
  bool submit = false;
};

/// A sweep whose members tasks of Slurm are to run.
struct SlurmSweep {
  std::string file;
  std::string folder;
  SweepForm form = SweepForm::full;
  int cores = 0;        ///< of each task; 0: four
  double lease = 60.0;  ///< [s]
  bool quiet = false;
};

/// Writes the batch script of a sweep into its folder, and submits it where that is wanted. Returns the exit status.
/// Throws InputError before anything is written, and RunError if Slurm does not accept the script.
int hand_to_slurm(const SlurmSweep& sweep, const SlurmOptions& options);

}  // namespace repose
