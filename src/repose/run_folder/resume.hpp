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

/// A run folder whose run can be resumed.
struct InterruptedRun {
  std::unique_ptr<FolderLock> lock;
  bool finished = false;
  bool completed = false;  ///< it had finished without its analysis, which has been made now
  Scene scene;
  std::unique_ptr<Checkpoint> checkpoint;  ///< none: the run starts again
  std::vector<std::string> damaged;        ///< checkpoints that cannot be used, one line each
};

/// Takes hold of a run folder and finds out how far its run came. Throws InputError if it holds no run, a run that
/// failed, a scene that is not that of the run, or nothing but damaged checkpoints, and if another program writes
/// there.
InterruptedRun find_interrupted(const std::string& folder);

/// Brings a new simulation of the scene to where the run was, and returns the folder with its lock. Throws InputError.
template <int D>
std::unique_ptr<RunFolder<D>> resumed_folder(const std::string& folder, InterruptedRun& run, Simulation<D>& simulation);

}  // namespace repose
