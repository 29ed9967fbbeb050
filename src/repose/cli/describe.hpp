// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/run/simulation.hpp"
#include "repose/scene/scene.hpp"

#include <string>

namespace repose {

/// What a scene would run, for a reader: grains, laws, time step and why, expected end.
std::string describe(const Scene& scene);

/// What came out, in a few lines.
std::string describe_result(const Simulation& simulation);

/// Time [T] by which the run should be over: stop.time, or else the end of the pouring and some time to settle.
double expected_end(const Scene& scene);

/// Moving grain-steps up to a time, for grains that are poured at a constant rate.
double expected_work(const Scene& scene, double time);

}  // namespace repose
