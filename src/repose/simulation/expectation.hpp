// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/scene/scene.hpp"

namespace repose {

/// Time [T] by which a run should be over: stop.time, or else the end of the pouring and some time to settle.
double expected_end(const Scene& scene);

/// Moving grain-steps up to a time, those of the start and those that the source brings.
double expected_work(const Scene& scene, double time);

/// Grain-steps per second of one core, roughly; one of spheres costs about four of discs.
double expected_speed(const Scene& scene);

/// Memory [bytes] that a run needs, roughly: for its grains with their contacts and copies, and for the rows of the
/// series and the moments of the track that a day of computing can reach.
double expected_memory(const Scene& scene);

}  // namespace repose
