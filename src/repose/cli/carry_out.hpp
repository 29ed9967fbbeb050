// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run_folder/run_folder.hpp"
#include "repose/simulation/simulation.hpp"

namespace CLI {
class App;
}

namespace repose {

/// Adds the option --threads.
void add_threads(CLI::App& command, int& threads);

/// As many threads as were asked for, or, if none were, as have enough to do.
int threads_for(const Scene& scene, int wanted);

/// Runs a simulation to its end, Ctrl-C or trouble, with its progress and result on the terminal; returns the exit
/// status. Throws RunError.
int carry_out(Simulation& simulation, RunFolder& folder, bool quiet);

}  // namespace repose
