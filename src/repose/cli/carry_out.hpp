// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run_folder/run_folder.hpp"
#include "repose/simulation/simulation.hpp"

namespace repose {

/// The number of threads asked for or, where none was, as many as have enough to do.
int threads_for(const Scene& scene, int wanted);

/// Runs a simulation to its end, to Ctrl-C or into trouble, and shows progress and result on the terminal. Returns the
/// exit status. Throws RunError.
int carry_out(Simulation& simulation, RunFolder& folder, bool quiet);

}  // namespace repose
