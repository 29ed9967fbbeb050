// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run_folder/checkpoint.hpp"
#include "repose/run_folder/run_folder.hpp"
#include "repose/scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace repose {

/// A run folder that can be gone on with.
struct InterruptedRun {
  std::unique_ptr<FolderLock> lock;
  bool finished = false;
  bool completed = false;  ///< it was finished but for the analysis, which has been made now
  Scene scene;
  std::unique_ptr<Checkpoint> checkpoint;  ///< none: the run starts anew
  std::vector<std::string> damaged;        ///< checkpoints that cannot be used, one line each
};

/// Takes hold of a run folder and looks at it. Throws InputError if it holds no run, a run that failed, a scene that is
/// not that of the run, or nothing but damaged checkpoints, and if another program writes there.
InterruptedRun find_interrupted(const std::string& folder);

/// The folder, whose lock is taken over, with the simulation (a new one of the scene) where the run was. Throws
/// InputError.
std::unique_ptr<RunFolder> taken_up(const std::string& folder, InterruptedRun& run, Simulation& simulation);

}  // namespace repose
