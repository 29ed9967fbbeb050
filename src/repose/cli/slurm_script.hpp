// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace repose {

/// An array of tasks of Slurm that share a sweep. Paths are absolute, because a task starts in a folder of its own.
struct SlurmTasks {
  std::string program;
  std::string file;    ///< of the sweep
  std::string folder;  ///< of the sweep
  int tasks = 1;
  int cores = 1;          ///< of each task
  std::string time;       ///< limit of each task, as Slurm writes it
  std::string partition;  ///< "": the default one
  double lease = 60.0;    ///< [s]
  bool quick = false;

  std::string script() const { return folder + "/slurm/batch.sh"; }
};

/// What is wrong with the time, the partition and the paths, "" if nothing.
std::string problem_with(const SlurmTasks& tasks);

/// A word as a shell reads it, with quotes where it needs them. A line of options in a batch script is read likewise.
std::string shell_word(const std::string& text);

/// The batch script. A task whose time ends writes checkpoints and is queued again; one that Slurm preempts or cancels
/// writes checkpoints.
std::string slurm_script(const SlurmTasks& tasks);

}  // namespace repose
