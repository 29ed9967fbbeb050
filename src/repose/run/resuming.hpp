// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/checkpoint.hpp"
#include "repose/run/run_folder.hpp"
#include "repose/scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace repose {

/// A run folder that can be gone on with.
struct InterruptedRun {
  bool finished = false;
  Scene scene;
  std::unique_ptr<Checkpoint> checkpoint;  ///< none: the run starts anew
  std::vector<std::string> damaged;        ///< checkpoints that cannot be used, one line each
};

/// Looks at a run folder. Throws InputError if it holds no run, a run that failed, a scene that is not that of the run,
/// or nothing but damaged checkpoints.
InterruptedRun find_interrupted(const std::string& folder);

/// The folder, held for writing, with the simulation (a new one of the scene) where the run was. Throws InputError.
std::unique_ptr<RunFolder> taken_up(const std::string& folder, const InterruptedRun& run, Simulation& simulation);

}  // namespace repose
