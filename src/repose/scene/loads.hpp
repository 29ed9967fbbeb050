// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/grains.hpp"
#include "repose/scene/problems.hpp"
#include "repose/scene/scene.hpp"

#include <cstdint>
#include <string>

namespace repose {

/// The reason why no load can act on the grain of an id; "" if one can. `at_start` are the grains at the start, by
/// ascending id; the source releases others.
template <int D>
std::string load_problem(const Scene& scene, const Grains<D>& at_start, std::int64_t id);

/// Checks the loads. Those of a scene with start.from wait for its grains, which the simulation reads.
void check_loads(const Scene& scene, Problems& problems);

}  // namespace repose
