// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/start_file.hpp"
#include "repose/scene/overlaps.hpp"
#include "repose/scene/problems.hpp"
#include "repose/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace repose {

/// Where the units of a file contradict those of the scene and start.scale does not relate them: a problem if its sizes
/// are far from those of the scene, else a warning.
template <int D>
void check_units(const StartState<D>& state, const Scene& scene, Problems& problems,
                 std::vector<std::string>& warnings);

/// Adds what is suspicious in a file: sides and width of its box, sizes and masses far from those of the scene,
/// overlaps.
template <int D>
void add_warnings(const StartState<D>& state, const Scene& scene, const std::optional<DeepestOverlap>& deepest,
                  std::vector<std::string>& warnings);

/// What was read, for `repose check`: format, snapshot, columns, units, box, extent, sizes, masses, deepest overlap.
template <int D>
std::string describe_start(const StartState<D>& state, const Scene& scene,
                           const std::optional<DeepestOverlap>& deepest);

}  // namespace repose
