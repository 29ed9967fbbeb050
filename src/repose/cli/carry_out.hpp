// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run_folder/run_folder.hpp"
#include "repose/simulation/simulation.hpp"

#include <string>

namespace repose {

/// The number of threads asked for, but no more than the machine has and than have some grains each; or, where none was
/// asked for, as many as have enough to do.
int threads_for(const Scene& scene, int wanted);

/// Throws InputError if a run needs more memory than the machine has. `name` stands for it in the message.
void check_memory(const Scene& scene, const std::string& name);

/// Runs a simulation to its end, to Ctrl-C or into trouble, and shows progress and result on the terminal. Returns the
/// exit status. Throws RunError.
template <int D>
int carry_out(Simulation<D>& simulation, RunFolder<D>& folder, bool quiet);

}  // namespace repose
