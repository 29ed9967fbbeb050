// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/io/start_file.hpp"
#include "repose/scene/problems.hpp"
#include "repose/scene/scene.hpp"

#include <optional>
#include <string>

namespace repose {

/// Overlap over the mean diameter beyond which two grains at the start are refused, unless both come from a run.
inline constexpr double largest_overlap_at_start = 0.25;
/// Two grains of a file that overlap by more are warned of.
inline constexpr double usual_overlap_at_start = 0.1;

/// Refuses grains at the start that lie at one place or overlap deeply: of the file, placed, and of the base and the
/// lattice. Each pair is named, with ids and lines of the file. Two fixed grains may overlap.
template <int D>
void check_overlaps(const Scene& scene, const std::optional<StartState<D>>& start, Problems& problems);

/// The two grains of a start that overlap most.
struct DeepestOverlap {
  double relative = 0.0;  ///< over their mean diameter
  std::string grains;     ///< "grains 3 and 7 (lines 4 and 8)"
};
template <int D>
std::optional<DeepestOverlap> deepest_overlap(const StartState<D>& start, const Scene& scene);

}  // namespace repose
